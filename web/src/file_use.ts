/** What a file is read for, numbered as in wasm/app/file_use.h. */
export const fileUse = { document: 0, otherClip: 1, bodyModel: 2 } as const;
export type FileUse = (typeof fileUse)[keyof typeof fileUse];

/** What a person wants with a file that is simply opened: JSON is a model of the body. */
export function usualUse(name: string): FileUse {
  return /\.json$/i.test(name) ? fileUse.bodyModel : fileUse.document;
}
