// Light or dark: as the system says, until the reader says otherwise; the choice is kept where the browser keeps anything.

const system_is_dark = matchMedia("(prefers-color-scheme: dark)");

function kept_theme() {
  try {
    return localStorage.getItem("theme");
  } catch {
    return null;  // a browser that keeps nothing for files
  }
}

function keep_theme(theme) {
  try {
    localStorage.setItem("theme", theme);
  } catch {
    // the choice holds for this page
  }
}

function is_dark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : system_is_dark.matches;
}

function colours_have_changed() {
  for (const act of when_colours_change) act();
}

function add_theme_switch() {
  const kept = kept_theme();
  if (kept === "dark" || kept === "light") document.documentElement.dataset.theme = kept;
  const button = element("button", {type: "button", class: "theme"});
  const tell = () => (button.textContent = is_dark() ? "Light colours" : "Dark colours");
  when_colours_change.push(tell);
  button.addEventListener("click", () => {
    document.documentElement.dataset.theme = is_dark() ? "light" : "dark";
    keep_theme(document.documentElement.dataset.theme);
    colours_have_changed();
  });
  system_is_dark.addEventListener("change", colours_have_changed);
  tell();
  document.querySelector("main").prepend(button);
}

