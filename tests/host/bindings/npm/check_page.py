#!/usr/bin/python3
"""The example page of the npm package in headless Chromium, served from the package's folder.

  check_page.py PACKAGE_FOLDER

The page draws in a worker and by itself; a worker is aborted; SVG is made; nothing is written to the console as an error.
"""
import functools
import http.server
import sys
import threading
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=sys.argv[1]))
threading.Thread(target=server.serve_forever, daemon=True).start()
place = f"http://127.0.0.1:{server.server_address[1]}"

options = Options()
for word in ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1000,1000"]:
    options.add_argument(word)
options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
driver.set_script_timeout(120)
failures = []


def check(right, what):
    if not right:
        failures.append(what)
        print("FAILED:", what, file=sys.stderr)


def wait(script, what):
    end = time.time() + 60
    while time.time() < end:
        if driver.execute_script("return " + script):
            return
        time.sleep(0.05)
    check(False, what + ": " + driver.execute_script("return document.getElementById('message').textContent"))


try:
    driver.get(place + "/example.html")
    wait("document.documentElement.dataset.drawn === '1'", "the first drawing")
    message = driver.execute_script("return document.getElementById('message').textContent")
    # 192 x 16 quadrangles, two triangles each.
    check("6144 faces" in message, message)
    check(driver.execute_script("return document.querySelectorAll('path.silhouette').length") == 1, "silhouettes are drawn")
    check(driver.execute_script("return document.querySelectorAll('path.hidden').length") == 0, "no hidden lines")
    driver.execute_script("document.getElementById('hidden').click()")
    wait("document.querySelectorAll('path.hidden').length === 1", "hidden lines")
    driver.execute_script("document.getElementById('save').click()")
    result = driver.execute_async_script("""
      const finish = arguments[arguments.length - 1];
      (async () => {
        const {hiddenLines} = await import('./index.js');
        const mesh = {positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]), index: new Uint16Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])};
        const here = await hiddenLines(mesh, {view: 'iso', hidden: true});
        const there = await hiddenLines(mesh, {view: 'iso', hidden: true, worker: true});
        const stop = new AbortController();
        const ended = await hiddenLines(mesh, {worker: true, signal: stop.signal, progress: () => stop.abort()}).catch(error => error.name);
        const wrong = await hiddenLines({positions: []}).catch(error => error.message);
        return {lines: here.kinds.length, same: here.svg() === there.svg(), ended, wrong};
      })().then(finish, error => finish({failed: String(error)}));
    """)
    check(result == {"lines": 6, "same": True, "ended": "AbortError",
                     "wrong": "mesh: positions: found an array of 0, expected a Float32Array or Float64Array"}, result)
    bad = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE" and "favicon" not in entry["message"]]
    check(not bad, bad)
    if len(sys.argv) > 2:
        driver.save_screenshot(sys.argv[2])
finally:
    driver.quit()
    server.shutdown()
sys.exit(1 if failures else 0)
