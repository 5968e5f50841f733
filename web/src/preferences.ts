const key = "marey.preferences";

/** What is kept between visits as JSON text; "" where there is none or the browser forbids it. */
export function loadPreferences(): string {
  try {
    return localStorage.getItem(key) ?? "";
  } catch {
    return "";
  }
}

export function storePreferences(json: string): void {
  try {
    localStorage.setItem(key, json);
  } catch {
    // A page without storage works as on the first visit.
  }
}

/** Gives the HTML around the canvas the theme that was chosen in the program. */
export function applyTheme(preferencesJson: string): void {
  let theme: unknown;
  try {
    theme = JSON.parse(preferencesJson)?.theme;
  } catch {
    theme = undefined;
  }
  if (theme === "dark" || theme === "light") document.documentElement.dataset["theme"] = theme;
  else delete document.documentElement.dataset["theme"];
}
