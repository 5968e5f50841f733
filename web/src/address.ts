/** What the page's own address asks to be opened: `?src=URL` or `?sample=NAME`. */
export interface Request {
  src?: URL;
  sample?: string;
}

export function readAddress(search: string, base: string): Request {
  const parameters = new URLSearchParams(search);
  const sample = parameters.get("sample");
  if (sample !== null && /^[\w-]+$/.test(sample)) return { sample };
  const src = parameters.get("src");
  if (src === null) return {};
  try {
    return { src: new URL(src, base) };
  } catch {
    return {};
  }
}

/** Name of the file that a URL stands for, "walk.bvh". */
export function fileNameOf(url: URL): string {
  const last = url.pathname.split("/").pop() ?? "";
  try {
    return decodeURIComponent(last) || "file.bvh";
  } catch {
    return last;
  }
}

/**
 * Lets the browser refuse every connection but to the page's own host and the one that its address names. Browsers
 * apply a policy that is added later on top of the one in index.html.
 */
export function lockConnections({ src }: Request): void {
  const meta = document.createElement("meta");
  meta.httpEquiv = "Content-Security-Policy";
  meta.content = `connect-src 'self'${src && /^https?:$/.test(src.protocol) ? ` ${src.origin}` : ""}`;
  document.head.append(meta);
}
