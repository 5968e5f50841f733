/** Drops files on the page as a file manager does. */
export async function drop(page, files, { release = true } = {}) {
  const data = await page.evaluateHandle((list) => {
    const transfer = new DataTransfer();
    for (const { name, text } of list) transfer.items.add(new File([text], name));
    return transfer;
  }, files);
  await page.dispatchEvent("#canvas", "dragenter", { dataTransfer: data });
  await page.dispatchEvent("#canvas", "dragover", { dataTransfer: data });
  if (release) await page.dispatchEvent("#canvas", "drop", { dataTransfer: data });
}
