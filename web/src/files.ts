import { hideNotice, showNotice } from "./notice";

/** Opens a file in the program; what is wrong with it is said on the page. */
export type OpenFile = (name: string, data: Blob) => void;

const looksLikeBvh = /^[\s\ufeff]*HIERARCHY\b/i;

/** The ways in which a person gives a file to the page: picker, drop and paste. */
export class Files {
  private readonly input = document.getElementById("file-input") as HTMLInputElement;
  private readonly overlay = document.getElementById("drop-overlay")!;
  private openChosen: OpenFile;

  constructor(private readonly open: OpenFile) {
    this.openChosen = open;
    this.input.addEventListener("change", () => {
      this.openFirst([...(this.input.files ?? [])], this.openChosen);
      this.input.value = "";
    });
    window.addEventListener("dragover", (event) => this.dragOver(event));
    window.addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) this.overlay.hidden = true;
    });
    window.addEventListener("drop", (event) => this.drop(event));
  }

  /** Lets the person choose a file; what is dropped or pasted meanwhile goes its usual way. */
  ask(open: OpenFile = this.open): void {
    this.openChosen = open;
    this.input.click();
  }

  /** Files and BVH text from the clipboard; true when there was something to open. */
  paste(data: DataTransfer): boolean {
    const files = [...data.files];
    if (files.length > 0) {
      this.openFirst(files, this.open);
      return true;
    }
    const text = data.getData("text/plain");
    if (!looksLikeBvh.test(text)) return false;
    hideNotice();
    this.open("pasted.bvh", new Blob([text]));
    return true;
  }

  private dragOver(event: DragEvent): void {
    event.preventDefault();
    if (!event.dataTransfer) return;
    event.dataTransfer.dropEffect = "copy";
    this.overlay.hidden = false;
  }

  private drop(event: DragEvent): void {
    event.preventDefault();
    this.overlay.hidden = true;
    if (event.dataTransfer && !this.paste(event.dataTransfer)) showNotice("What was dropped is not a BVH file.");
  }

  /** Opens the first BVH file, or the only file whatever its name. */
  private openFirst(files: File[], open: OpenFile): void {
    if (files.length === 0) return;
    const file = files.find(({ name }) => /\.bvh$/i.test(name)) ?? files[0]!;
    hideNotice();
    open(file.name, file);
    if (files.length > 1) showNotice(`${files.length} files were given; ${file.name} was opened, one at a time.`);
  }
}

/** Hands bytes to the browser as a download. */
export function download(name: string, data: Uint8Array<ArrayBuffer> | Blob): void {
  const url = URL.createObjectURL(new Blob([data], { type: "application/octet-stream" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
