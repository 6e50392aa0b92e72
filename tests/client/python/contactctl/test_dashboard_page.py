"""Tests the page of contactctl dashboard in a headless Chromium. Skipped if NiceGUI was not available from PyPI."""

import http.server
import os
import re
import signal
import socket
import threading
import urllib.error
import urllib.request
from pathlib import Path

import pytest

from support.browser import PROGRAM, Browser
from support.daemons import eventually
from support.problems import CATTANEO, GRID, LONG, QUICK, STEEL
from support.slowness import SLOWER

PACKAGES = [*Path(os.environ.get("CONTACTD_DASHBOARD", "/nowhere")).glob("lib/python3*/site-packages")]

pytestmark = [
    pytest.mark.skipif(not PACKAGES, reason="NiceGUI could not be had from PyPI"),
    pytest.mark.skipif(PROGRAM is None, reason="there is no Chromium"),
    pytest.mark.timeout(120 * SLOWER),
]


def with_packages(ctl):
    """They precede Debian's own packages, which are older."""
    ctl.environment["PYTHONPATH"] = f"{PACKAGES[0]}{os.pathsep}{ctl.environment['PYTHONPATH']}"
    return ctl


class Dashboard:
    """A running one."""

    def __init__(self, ctl, *words):
        self.process = with_packages(ctl).start("dashboard", "--port", "0", "--interval", "0.2", *words)
        self.link = self.process.stdout.readline().strip()
        assert self.link, self.process.stderr.read()

    def end(self):
        """Returns its exit code after Ctrl-C, and its output."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        _, said = self.process.communicate(timeout=30 * SLOWER)
        return self.process.returncode, said


@pytest.fixture(scope="module")
def dashboard(shared_ctl):
    """Uses the daemon that the tests of this file share."""
    made = Dashboard(shared_ctl)
    yield made
    assert made.end() == (130, "")


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with Browser(tmp_path_factory.mktemp("browser")) as driven:
        yield driven
        assert driven.problems == []


@pytest.fixture
def page(dashboard, browser):
    browser.open(dashboard.link)
    browser.wait_for("serving", ".state")
    return browser


@pytest.fixture
def page_of_own(own, daemon, browser):
    """Uses a separate daemon."""
    made = Dashboard(own)
    browser.open(made.link)
    browser.wait_for("serving", ".state")
    yield browser
    assert made.end() == (130, "")


def show(page, tab):
    page.click(".q-tab", tab)


def test_a_build_is_followed_and_cancelled(page, shared, background):
    waiting = background(shared.get_ic, STEEL, GRID, LONG)
    page.wait_for("build-", ".job")
    build = page.text(".job").split()[0]
    eventually(lambda: re.search(r"[1-9]\d* %", page.text(".job .part")))
    bar = "document.querySelector('.job .q-linear-progress').getAttribute('aria-valuenow')"
    assert float(page.evaluate(bar)) > 0
    page.wait_for("finite elements, a half-space", ".job .what")
    page.click(".job .cancel")
    page.wait_for(f"End {build}?", ".question")
    asked = page.text(".question")
    assert "It is building a table: finite elements" in asked
    assert f"It belongs to uid:{os.getuid()}." in asked
    page.click(".question .keep")
    eventually(lambda: page.text(".question") == "")
    assert not waiting.done()
    page.click(".job .cancel")
    page.click(".question .end")
    page.wait_for(f"{build} is cancelled.")
    page.wait_for("There are no jobs.", ".jobs")
    assert waiting.exception(30).name == "CANCELLED"
    assert build not in page.text(".jobs")


def test_the_picture_of_a_solve_is_drawn(page, shared):
    solution = shared.solve(CATTANEO)
    show(page, "Solves")
    page.wait_for("contact.solve", ".solves tbody")
    row = page.text(".solves tbody tr")
    assert f"{solution.pmax:.5g}" in row
    assert f"{solution.Fn:.5g}" in row
    assert "40 x 40" in row
    page.click(".solves tbody tr")
    picture = "document.querySelector('.picture img')"
    eventually(lambda: page.evaluate(f"{picture}?.complete && {picture}.naturalWidth > 0"))
    size, colours = page.evaluate(
        f"""(() => {{
            const image = {picture}, canvas = document.createElement('canvas');
            [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
            const context = canvas.getContext('2d');
            context.drawImage(image, 0, 0);
            const pixels = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
            return [[canvas.width, canvas.height], new Set(pixels).size];
        }})()"""
    )
    assert min(size) > 300
    assert colours > 100  # shows pressures, not an empty frame
    page.wait_for(", contact.solve at ", ".q-dialog")


def test_a_daemon_that_goes_away_and_comes_back(page_of_own, daemon, daemons, client):
    page = page_of_own
    client.solve(CATTANEO)
    show(page, "Solves")
    page.wait_for("contact.solve", ".solves")
    daemon.stop()
    page.wait_for("away", ".state")
    page.wait_for("The dashboard keeps trying.", ".away")
    daemons.start()
    page.wait_for("serving", ".state")
    eventually(lambda: "has not answered" not in page.text())
    eventually(lambda: "contact.solve" not in page.text(".solves"))  # it has forgotten them, and so has the page


def test_it_may_begin_before_its_daemon(daemons, browser, own, daemon):
    daemon.stop()
    made = Dashboard(own)
    browser.open(made.link)
    browser.wait_for("away", ".state")
    daemons.start()
    browser.wait_for("serving", ".state")
    assert made.end() == (130, "")


def test_the_page_is_there_while_its_daemon_does_not_answer(own, daemon, browser):
    daemon.process.send_signal(signal.SIGSTOP)
    try:
        made = Dashboard(own)
        browser.open(made.link)
        browser.wait_for("The dashboard keeps trying.", ".away")
    finally:
        daemon.process.send_signal(signal.SIGCONT)
    browser.wait_for("serving", ".state")
    assert made.end() == (130, "")


def test_tables_sessions_and_configuration_are_shown(page, shared):
    table = shared.get_ic(STEEL, GRID, QUICK)
    show(page, "Tables")
    page.wait_for(table.key[:16])
    page.wait_for("against the closed form")
    with shared.session(CATTANEO) as session:
        session.step()
        show(page, "Sessions")
        page.wait_for("1600")
    page.wait_for("No session is open.")
    show(page, "Configuration")
    page.wait_for("recent_solves.count")
    assert shared.endpoint not in page.text(".q-tab-panel")


def test_rates_are_drawn(page, shared):
    shared.solve(CATTANEO)
    eventually(lambda: page.evaluate("document.querySelectorAll('canvas').length") == 2)
    page.wait_for("0 of 2 busy", ".figures")


def prefer(page, scheme):
    page.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])


def luminances(page, *selectors):
    """Returns the luminance of background and text of elements, from 0 to 1, where something is drawn behind them."""
    script = """(selector => {
        const luminance = colour => {
            const [r, g, b, a = 1] = colour.match(/[0-9.]+/g).map(Number);
            return a === 0 ? null : (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
        };
        let at = document.querySelector(selector), ground = null;
        const text = luminance(getComputedStyle(at).color);
        for (; at && ground === null; at = at.parentElement) ground = luminance(getComputedStyle(at).backgroundColor);
        return [ground, text];
    })"""
    return [page.evaluate(f"{script}({selector!r})") for selector in selectors]


def test_colours_are_dark_where_the_browser_prefers_them(page, shared):
    shared.solve(CATTANEO)
    everywhere = (".figures .text-gray-600", ".jobs", ".figures .font-medium")
    try:
        prefer(page, "dark")
        eventually(lambda: page.evaluate("document.body.classList.contains('body--dark')"))
        assert all(ground < 0.2 and text > 0.6 for ground, text in luminances(page, *everywhere))
        show(page, "Solves")
        page.wait_for("contact.solve", ".solves tbody")
        assert all(ground < 0.2 and text > 0.6 for ground, text in luminances(page, ".solves tbody td", ".solves th"))
        prefer(page, "light")
        eventually(lambda: not page.evaluate("document.body.classList.contains('body--dark')"))
        assert all(ground > 0.8 and text < 0.5 for ground, text in luminances(page, ".solves tbody td", ".solves th"))
    finally:
        prefer(page, "")


def test_forces_that_are_rounding_only_are_zero(page, shared):
    solution = shared.solve(CATTANEO)
    assert 0 < abs(solution.Fy) < 1e-12 * solution.Fn or solution.Fy == 0
    show(page, "Solves")
    page.wait_for("contact.solve", ".solves tbody")
    heads = page.evaluate("[...document.querySelectorAll('.solves th')].map(one => one.innerText)")
    cells = page.evaluate("[...document.querySelector('.solves tbody tr').querySelectorAll('td')].map(one => one.innerText)")
    row = dict(zip(heads, cells, strict=True))
    assert row["Fy (N)"] == "0" and row["Fx (N)"] == f"{solution.Fx:.5g}"


def status_of(link, **headers):
    try:
        with urllib.request.urlopen(urllib.request.Request(link, headers=headers), timeout=20) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read().decode()


#: Overlapping texts, and elements wider than the window that do not scroll.
OVERLAPS = """(() => {
    const boxes = [];
    const walker = document.createTreeWalker(document.querySelector('.nicegui-content'), NodeFilter.SHOW_TEXT);
    for (let node; (node = walker.nextNode());) {
        if (!node.textContent.trim()) continue;
        const range = document.createRange();
        range.selectNodeContents(node);
        const scrolls = node.parentElement.closest('.q-table__middle');
        for (const box of range.getClientRects()) {
            if (box.width < 1 || box.height < 1 || scrolls) continue;
            boxes.push([node.textContent, box]);
        }
    }
    const wrong = [];
    boxes.forEach(([text, a], i) => {
        if (a.right > document.documentElement.clientWidth + 1 || a.left < 0) wrong.push([text, 'is cut off']);
        for (const [other, b] of boxes.slice(i + 1)) {
            const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
            const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
            if (width > 1 && height > 3) wrong.push([text, other]);
        }
    });
    if (document.documentElement.scrollWidth > document.documentElement.clientWidth) wrong.push(['the page', 'is too wide']);
    return wrong;
})()"""


@pytest.fixture
def at_width(browser):
    yield lambda width: browser.resize(width, 900)
    browser.send("Emulation.clearDeviceMetricsOverride")


@pytest.mark.parametrize("width", [390, 700, 1400])
def test_nothing_lies_on_anything_else(page, shared, background, at_width, width):
    at_width(width)
    waiting = background(shared.get_ic, STEEL, GRID, LONG)
    page.wait_for("build-", ".job")
    for tab in ("Work", "Solves", "Tables", "Sessions", "Configuration"):
        show(page, tab)
        eventually(lambda: page.evaluate(OVERLAPS) == [], "texts lie on one another")
    (job,) = shared.jobs()
    shared.cancel_job(job.job)
    assert waiting.exception(30).name == "CANCELLED"


def test_two_dashboards_in_one_browser_leave_each_other_alone(dashboard, browser, lonely):
    other = Dashboard(lonely)
    browser.open(dashboard.link)
    browser.wait_for("serving", ".state")
    browser.open(other.link)
    browser.wait_for("away", ".state")
    for link, state in ((dashboard.link, "serving"), (other.link, "away"), (dashboard.link, "serving")):
        browser.open(link.partition("?")[0])
        browser.wait_for(state, ".state")
    assert "token" not in browser.evaluate("location.href")
    assert other.end() == (130, "")


def test_what_another_page_of_the_machine_gets_from_the_browser_opens_nothing(dashboard, browser):
    """Cookies ignore ports, so a page on another port receives ours."""
    received = []

    class Page(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            received.append(self.headers)
            self.send_response(200)
            self.end_headers()
            self.wfile.write(b"<title>another page</title>")

        def log_message(self, *_):
            pass

    browser.open(dashboard.link)
    browser.wait_for("serving", ".state")
    base = dashboard.link.partition("?")[0]
    with http.server.HTTPServer(("127.0.0.1", 0), Page) as server:
        serving = threading.Thread(target=server.serve_forever)
        serving.start()
        try:
            browser.open(f"http://127.0.0.1:{server.server_port}/")
            eventually(lambda: received)
            eventually(lambda: browser.evaluate("document.title") == "another page")
            assert browser.evaluate("localStorage.length") == 0
            refused = browser.evaluate(f"fetch('{base}', {{credentials: 'include'}}).then(() => false, () => true)")
        finally:
            server.shutdown()
            serving.join()
    assert refused
    cookie = received[0]["Cookie"]
    assert "contactd_dashboard_" in cookie  # it has it
    assert not any("token" in str(headers) for headers in received)
    for path in ("_nicegui_ws/socket.io/?EIO=4&transport=polling", "none/"):
        assert status_of(f"{base}{path}", Cookie=cookie)[0] == 403
    status, said = status_of(base, Cookie=cookie)
    assert status == 200
    assert "serving" not in said
    assert "ipc://" not in said


def test_it_listens_on_the_loopback_only(dashboard):
    port = int(re.search(r":(\d+)/", dashboard.link)[1])
    assert dashboard.link.startswith("http://127.0.0.1:")
    with socket.socket() as other:
        other.settimeout(1)
        assert other.connect_ex(("127.0.0.2", port)) != 0


def test_a_port_that_is_taken_is_told(dashboard, lonely):
    port = re.search(r":(\d+)/", dashboard.link)[1]
    ended = with_packages(lonely).alone("dashboard", "--port", port)
    assert ended.code == 2
    assert f"127.0.0.1 port {port}: Address already in use." in ended.err


@pytest.mark.parametrize(("number", "code"), [(signal.SIGTERM, 143), (signal.SIGINT, 130)])
def test_signals_end_it(lonely, number, code):
    made = Dashboard(lonely)
    made.process.send_signal(number)
    assert made.process.wait(30 * SLOWER) == code
    made.end()
    with pytest.raises(urllib.error.URLError):
        status_of(made.link)


def test_its_address_can_be_read_by_scripts(lonely):
    with with_packages(lonely).start("dashboard", "--port", "0", "--json") as process:
        assert re.fullmatch(r'\{"address": "http://127\.0\.0\.1:\d+/\?token=[\w-]+"\}\n', process.stdout.readline())
        process.send_signal(signal.SIGTERM)
        assert process.wait(30) == 143
