/** Before the page loads: `limitMemory(bytes)` has the browser refuse more memory to WebAssembly than so much. */
export function installMemoryLimit() {
  let limit = Infinity;
  const { grow } = WebAssembly.Memory.prototype;
  WebAssembly.Memory.prototype.grow = function (pages) {
    if (this.buffer.byteLength + pages * 65536 > limit) throw new RangeError("no more memory, for a test");
    return grow.call(this, pages);
  };
  window.limitMemory = (bytes) => (limit = bytes);
}
