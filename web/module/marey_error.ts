/** Why a file or a call was refused. `line` and `column` count from 1; 0 when the reason has no place in a file. */
export class MareyError extends Error {
  override readonly name = "MareyError";
  /** Stable identifier of the reason: "missing_motion". */
  readonly code: string;
  readonly line: number;
  readonly column: number;

  constructor(code: string, message: string, line = 0, column = 0) {
    super(message);
    this.code = code;
    this.line = line;
    this.column = column;
  }
}
