"""Serves the page at /, which loads the dashboard with the key stored for this origin."""

__all__ = ["DOOR"]

DOOR = b"""<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>contactd</title>
<p id="said"><noscript>The dashboard needs JavaScript.</noscript></p>
<script>
  const given = location.hash.slice(1);
  if (given) {
    localStorage.setItem("contactd_dashboard", given);
    history.replaceState(null, "", "/");
  }
  const key = localStorage.getItem("contactd_dashboard") ?? "none";
  fetch(`/${encodeURIComponent(key)}/`, { cache: "no-store" }).then(async (answer) => {
    const said = await answer.text();
    const is_page = (answer.headers.get("content-type") ?? "").startsWith("text/html");
    if (!answer.ok && !is_page) throw new Error(said);
    document.open();
    document.write(said);
    document.close();
  }).catch((error) => { document.getElementById("said").textContent = error.message; });
</script>
</html>
"""
