/* A button on each block of code that copies it, without the prompts of a terminal. */
"use strict";

function copied(pre) {
  const lines = pre.innerText.replace(/\n$/, "").split("\n");
  if (!lines.some((line) => line.startsWith("$ "))) return lines.join("\n");
  return lines.filter((line) => line.startsWith("$ ")).map((line) => line.slice(2)).join("\n");
}

async function put(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch { /* Pages that are opened as files may not have a clipboard in all browsers; the selection has. */
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}

document.addEventListener("DOMContentLoaded", () => {
  for (const block of document.querySelectorAll("div.highlight")) {
    const button = document.createElement("button");
    button.className = "copy-code";
    button.type = "button";
    button.textContent = "Copy";
    button.setAttribute("aria-label", "Copy this code");
    button.addEventListener("click", async () => {
      await put(copied(block.querySelector("pre")));
      button.textContent = "Copied";
      setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });
    block.append(button);
  }
});
