/** Puts text on the system's clipboard; silently not where the browser forbids it. */
export function copyText(text: string): void {
  if (navigator.clipboard) {
    navigator.clipboard.writeText(text).catch(() => copyBySelection(text));
  } else {
    copyBySelection(text);
  }
}

// Pages that are not served over https have no navigator.clipboard.
function copyBySelection(text: string): void {
  const copied = (event: ClipboardEvent): void => {
    event.clipboardData?.setData("text/plain", text);
    event.preventDefault();
  };
  document.addEventListener("copy", copied, { once: true });
  document.execCommand("copy");
  document.removeEventListener("copy", copied);
}
