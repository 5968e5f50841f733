/** What Emscripten makes of wasm/bindings/module*.cpp. Addresses and sizes are in bytes. */
export interface CoreProgram {
  readonly HEAPU8: Uint8Array<ArrayBuffer>;
  readonly HEAPF32: Float32Array<ArrayBuffer>;
  readonly HEAPF64: Float64Array<ArrayBuffer>;
  _malloc(size: number): number;
  _free(address: number): void;
  _marey_used_memory(): number;
  _marey_reader_options(strict: number, namesIn: number): void;
  _marey_reader_limit(name: number, nameSize: number, value: number): number;
  _marey_reader_open(expectedBytes: number): number;
  _marey_reader_piece(reader: number, size: number): number;
  _marey_reader_feed(reader: number, size: number): number;
  _marey_reader_frame_count(reader: number): number;
  _marey_reader_clip_so_far(reader: number, mostFrames: number): number;
  _marey_reader_finish(reader: number): number;
  _marey_reader_dispose(reader: number): void;
  _marey_clip_parse_table(text: number, size: number, strict: number, figure: number): number;
  _marey_clip_dispose(clip: number): void;
  _marey_clip_is_open(clip: number): number;
  _marey_clip_text(clip: number): number;
  _marey_clip_text_size(clip: number): number;
  _marey_clip_samples(clip: number, channel: number): number;
  _marey_clip_world_positions(clip: number, first: number, count: number): number;
  _marey_clip_position_rule(clip: number): number;
  _marey_clip_set_position_rule(clip: number, rule: number): void;
  _marey_clip_write(clip: number, decimals: number, lineEnd: number, first: number, count: number): void;
  _marey_clip_write_table(clip: number, ofPositions: number, unit: number, unitSize: number, first: number,
    count: number): void;
  _marey_clip_write_for(clip: number, target: number, targetSize: number, referencePose: number, decimals: number,
    lineEnd: number): number;
  _marey_clip_analyse(clip: number, request: number, requestSize: number): number;
  _marey_clip_body(clip: number, request: number, requestSize: number): number;
  _marey_clip_numbers(clip: number): number;
  _marey_clip_report(clip: number): number;
  _marey_clip_report_size(clip: number): number;
}
