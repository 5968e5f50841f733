import { MareyError } from "../module/marey_error";

/** A file that is to be read piece by piece. */
export interface FileSource {
  /** Bytes, 0 if nobody knows. */
  size: number;
  /** Ends early when `stopped` says so. */
  pieces(stopped: AbortSignal): AsyncIterable<Uint8Array>;
  /** What was read, for the failure page; undefined if it was not kept. */
  kept(): Blob | undefined;
}

/** A file that is kept for the failure page although the browser does not hold it. */
const mostKeptBytes = 64 * 1024 * 1024;

async function* piecesOf(stream: ReadableStream<Uint8Array>, stopped: AbortSignal): AsyncGenerator<Uint8Array> {
  const reader = stream.getReader();
  const stop = (): void => void reader.cancel().catch(() => {});
  stopped.addEventListener("abort", stop);
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      yield value;
    }
  } finally {
    stopped.removeEventListener("abort", stop);
    stop();
  }
}

/** A file on disk, or bytes that a caller handed over. */
export function sourceOf(data: Blob): FileSource {
  return { size: data.size, pieces: (stopped) => piecesOf(data.stream(), stopped), kept: () => data };
}

/** A file that a server sends. */
export function sourceOfResponse(response: Response): FileSource {
  // The length of a compressed answer is not that of the file.
  const isPlain = !response.headers.get("content-encoding");
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  async function* pieces(stopped: AbortSignal): AsyncGenerator<Uint8Array> {
    if (!response.body) throw new MareyError("not_loaded", "The server sent nothing.");
    for await (const piece of piecesOf(response.body, stopped)) {
      bytes += piece.length;
      if (bytes <= mostKeptBytes) parts.push(new Uint8Array(piece));
      else parts.length = 0;
      yield piece;
    }
  }
  return {
    size: isPlain ? Number(response.headers.get("content-length") ?? 0) : 0,
    pieces,
    kept: () => (bytes <= mostKeptBytes ? new Blob(parts) : undefined),
  };
}
