/**
 * Something that the page, not the program, has to say: a file that could not be read or fetched. Stays until closed.
 */
export function showNotice(text: string): void {
  const notice = document.getElementById("notice")!;
  document.getElementById("notice-text")!.textContent = text;
  document.getElementById("notice-close")!.onclick = () => (notice.hidden = true);
  notice.hidden = false;
}

export function hideNotice(): void {
  document.getElementById("notice")!.hidden = true;
}
