/** A file of the page could not be read; the message says which and why. */
export class AssetError extends Error {}

/** Reports how many bytes of the awaited files have arrived. */
export type Progress = (loadedBytes: number) => void;

/**
 * Reads a file of the page: from the document itself in marey.html, else from beside it.
 * `path` is relative to the page, "fonts/icons.ttf".
 */
export async function readAsset(path: string, progress: Progress = () => {}): Promise<Uint8Array<ArrayBuffer>> {
  const embedded = document.querySelector(`script[data-file="${path}"]`);
  if (embedded) {
    const bytes = decodeBase64(embedded.textContent ?? "");
    progress(bytes.length);
    return bytes;
  }
  const response = await fetch(new URL(path, document.baseURI)).catch((error: unknown) => {
    throw new AssetError(`${path} could not be loaded (${error instanceof Error ? error.message : error}).`);
  });
  if (!response.ok) throw new AssetError(`${path} could not be loaded (the server answered ${response.status}).`);
  return readBody(response, progress);
}

/** Whether this is marey.html, which has nothing beside it. */
export function isOneFile(): boolean {
  return document.querySelector("script[data-file]") !== null;
}

async function readBody(response: Response, progress: Progress): Promise<Uint8Array<ArrayBuffer>> {
  if (!response.body) return new Uint8Array(await response.arrayBuffer());
  const chunks: Uint8Array[] = [];
  let size = 0;
  const reader = response.body.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    chunks.push(part.value);
    size += part.value.length;
    progress(size);
  }
  const bytes = new Uint8Array(size);
  let offset = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, offset);
    offset += chunk.length;
  }
  return bytes;
}

function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
