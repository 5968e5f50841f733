const replacement = 0xfffd;
const isPrivate = (letter: number) => letter >= 0xe000 && letter <= 0xf8ff;

/** The letters of two-byte codes, lead and trail in turn; 0 where a code has none, or one for private use. */
export function decodeLetters(set: "gbk" | "shift_jis", codes: Uint8Array): Uint16Array {
  const decoder = new TextDecoder(set);
  const letters = new Uint16Array(codes.length / 2);
  for (let i = 0; i < letters.length; i++) {
    const text = decoder.decode(codes.subarray(2 * i, 2 * i + 2));
    const letter = text.charCodeAt(0);
    if (text.length === 1 && letter !== replacement && !isPrivate(letter)) letters[i] = letter;
  }
  return letters;
}
