// Light or dark as the page around: a notebook tells it (see around.js). Alone, a page is as the browser prefers.
const darkRules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
  .filter((rule) => rule.media?.mediaText.includes("prefers-color-scheme: dark"));

addEventListener("message", ({ data, source }) => {
  if (source !== parent || !["light", "dark"].includes(data?.theme)) return;
  for (const rule of darkRules) rule.media.mediaText = data.theme === "dark" ? "all" : "not all";
  document.documentElement.style.colorScheme = data.theme;
  dispatchEvent(new Event("theme"));
});
