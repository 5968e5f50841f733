import type { Program } from "./program";
import type { TextField } from "./text_field";

/** Keys without a modifier that a browser would scroll, search or move the focus with. */
const plainKeysOfPrograms = /^(Tab|Escape|Enter|Backspace|Delete|Home|End|Page|Arrow|F1$|F2$)/;
/** Chords that text fields and editors share; everything else with Ctrl stays the browser's unless it is a shortcut. */
const editingLetters = new Set(["a", "c", "x", "y", "z"]);

/** Sends keys to the program, and leaves the browser its own. */
export class KeyboardInput {
  constructor(
    private readonly program: Program,
    private readonly textField: TextField,
    /** "ctrl+shift+z" for each shortcut of the program. */
    private readonly shortcuts: ReadonlySet<string>,
    private readonly effects: { wake(): void; takeInput(): void },
  ) {
    window.addEventListener("keydown", (event) => this.press(event, true));
    window.addEventListener("keyup", (event) => this.press(event, false));
    window.addEventListener("blur", () => this.setFocus(false));
    window.addEventListener("focus", () => this.setFocus(true));
  }

  private press(event: KeyboardEvent, down: boolean): void {
    if (event.isComposing || event.key === "Process" || event.key === "Unidentified" || isPaste(event)) return;
    if (event.target instanceof Element && event.target.closest("#failure, #notice")) return;
    this.program.pressKey(event.code, event.key, down, event);
    // While Cmd is held, macOS does not tell of other keys' release.
    if (down && event.metaKey) this.program.pressKey(event.code, event.key, false, event);
    if (down && this.isForProgram(event)) event.preventDefault();
    if (down && !this.isTyping(event)) this.textField.forgetTyped();
    if (down && !event.repeat) this.effects.takeInput();
    else this.effects.wake();
  }

  private isForProgram(event: KeyboardEvent): boolean {
    if (this.isTyping(event)) return false;
    if (this.shortcuts.has(chordOf(event))) return true;
    if (event.ctrlKey || event.metaKey) return editingLetters.has(event.key.toLowerCase());
    if (event.altKey) return false;
    return event.key.length === 1 || plainKeysOfPrograms.test(event.key);
  }

  /** The key makes a character in a text field, which then sends it. */
  private isTyping(event: KeyboardEvent): boolean {
    const altGraph = event.getModifierState("AltGraph");
    return this.textField.isActive && event.key.length === 1 && (altGraph || !(event.ctrlKey || event.metaKey));
  }

  private setFocus(focused: boolean): void {
    this.program.setFocus(focused);
    this.effects.wake();
  }
}

/** The paste event brings what is pasted, so the keys that ask for it are not sent. */
function isPaste(event: KeyboardEvent): boolean {
  const letter = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "v";
  return letter || (event.shiftKey && event.key === "Insert");
}

function chordOf(event: KeyboardEvent): string {
  const modifiers = [
    (event.ctrlKey || event.metaKey) && "ctrl",
    event.altKey && "alt",
    event.shiftKey && "shift",
  ].filter(Boolean);
  return normalChord([...modifiers, event.code === "Space" ? "space" : event.key].join("+"));
}

function normalChord(chord: string): string {
  const parts = chord.toLowerCase().split(/\+(?=.)/).map((part) => part.trim());
  const key = parts.pop() ?? "";
  return [...parts.sort(), key].join("+");
}

/** The chords in the shortcut texts of commands, "Ctrl+Y, Ctrl+Shift+Z". */
export function shortcutChords(shortcuts: string[]): Set<string> {
  return new Set(shortcuts.flatMap((text) => text.split(", ")).filter((text) => text !== "").map(normalChord));
}
