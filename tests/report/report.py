# SPDX-License-Identifier: MIT
"""report.py RESULTS OUT: the page OUT/report/index.html of what the golden checks left in RESULTS, with its pictures
beside it. The kill table, POV-Ray's figures and the chart are taken from OUT, where there are any."""
import html
import json
import math
import pathlib
import shutil
import sys

BINS_PER_DECADE, FIRST_DECADE = 2, -7  # of the histogram, as tests/golden/results.cpp counts
SMALLEST = 1e-9  # an error of 0 has no place on a logarithmic axis
CROP, SCALE = 13, 12  # pixels of a zoom, and how large each is shown
PICTURES = {"golden": "Golden", "render": "Render", "difference": "Difference ×16", "edges": "Edge mask",
            "outliers": "Outlier map"}
BOUNDS = {"interior": "Worst interior error", "mean_signed_error": "Mean signed error",
          "edge_outliers": "Edge outliers", "strays": "Strays"}


def fail(message):
    print(f"stagelight report: {message}", file=sys.stderr)
    sys.exit(1)


def text(value):
    return html.escape(str(value))


def number(value):
    return "none" if value is None else f"{value:.3g}"


def table(titles, rows, caption):
    """Of cells that are HTML. The first names its row."""
    head = "".join(f'<th scope="col">{title}</th>' for title in titles)
    body = "".join(f'<tr><th scope="row">{row[0]}</th>' + "".join(f"<td>{cell}</td>" for cell in row[1:]) + "</tr>"
                   for row in rows)
    return (f'<div class="wide" tabindex="0" role="region" aria-label="{caption}"><table><caption>{caption}</caption>'
            f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>")


def picture(check, what, extra=""):
    alt = f"{PICTURES[what]} of {check['scene']} on {check['device']['name']}"
    return f'<img src="{text(check["pictures"][what])}" alt="{text(alt)}" width="320" height="192"{extra}>'


def figure(check, what, note=""):
    if what not in check["pictures"]:
        return f'<figure class="none"><p>No picture</p><figcaption>{PICTURES[what]}: there is none</figcaption></figure>'
    return f"<figure>{picture(check, what)}<figcaption>{PICTURES[what]}{note}</figcaption></figure>"


def slider(check):
    name = text(check["id"])
    return (f'<div class="compare"><div class="stack">{picture(check, "golden")}'
            f'{picture(check, "render", " class=over")}<i class="line" aria-hidden="true"></i></div>'
            f'<label for="slide-{name}">Golden left of the line, render right of it</label>'
            f'<input type="range" id="slide-{name}" min="0" max="100" value="50" aria-valuetext="golden on 50 %">'
            f'<button type="button" class="blink" aria-pressed="false">Blink golden and render</button></div>')


def zoom(check):
    """The worst pixels: a table of values, and the pictures around the chosen one."""
    rows = [(f'<button type="button" class="place" data-x="{p["x"]}" data-y="{p["y"]}" aria-pressed="{str(i == 0).lower()}">'
             f'({p["x"]}, {p["y"]})</button>', number(p["error"]), text(p["kind"]),
             *("&nbsp; ".join(f"{value:.4f}" if value is not None else "NaN" for value in p[side])
               for side in ("golden", "render"))) for i, p in enumerate(check["worst"])]
    crops = "".join(f'<figure><div class="crop" role="img" data-what="{PICTURES[what]}" '
                    f'style="background-image:url({text(check["pictures"][what])})"></div>'
                    f"<figcaption>{PICTURES[what]}</figcaption></figure>" for what in ("golden", "render", "difference"))
    return ('<h4>Worst pixels</h4><p>Choose one to see what is around it. Values are linear light: red, green, blue.</p>'
            f'<div class="zoom">{crops}</div>'
            + table(["Pixel (x, y)", "Error", "Kind", "Golden", "Render"], rows, f"Worst pixels of {text(check['id'])}"))


def histogram(check):
    counts, bound = check["histogram"], check["tolerance"]["interior"]
    bar, height, base = 22, 100, 110
    tallest = math.log10(1 + max(counts))
    bars = ""
    for i, count in enumerate(counts):
        tall = height * math.log10(1 + count) / tallest
        bars += f'<rect x="{i * bar + 1}" y="{base - tall:.1f}" width="{bar - 2}" height="{tall:.1f}"/>'
    at = bar * (1 + BINS_PER_DECADE * (math.log10(bound) - FIRST_DECADE))
    labels = "".join(f'<text x="{bar * (1 + BINS_PER_DECADE * (e - FIRST_DECADE))}" y="{base + 16}">1e{e}</text>'
                     for e in range(FIRST_DECADE, 1, 2))
    beyond = sum(check["figures"][kind] for kind in ("interior_outliers", "edge_outliers", "strays"))
    said = (f"Pixels by error, both axes logarithmic. {beyond} of {sum(counts)} pixels are beyond the tolerance of "
            f"{number(bound)}, the dashed line.")
    return (f'<figure class="histogram"><svg viewBox="-14 0 {bar * len(counts) + 28} 132" role="img" aria-label="{said}">{bars}'
            f'<line x1="{at:.1f}" y1="4" x2="{at:.1f}" y2="{base}"/>{labels}</svg><figcaption>{said}</figcaption></figure>')


def article(check):
    rerun = f"./stagelight test -R 'DeviceMatchesGolden.*{check['id']}$'"
    update = f"./stagelight golden update {check['stage']} --reason TEXT"
    device = check["device"]
    parts = []
    if check["failure"]:
        parts.append(f'<p class="why"><strong>Failed:</strong> {text(check["failure"])}</p>')
    if {"golden", "render", "difference"} <= check["pictures"].keys():
        parts.append(slider(check))
    parts.append('<div class="pictures">' + figure(check, "golden") + figure(check, "render") + figure(check, "difference")
                 + figure(check, "edges", ": white where a pixel is on an edge")
                 + figure(check, "outliers", ": orange inside surfaces, blue on edges, yellow strays") + "</div>")
    if "figures" in check:
        figures = check["figures"]
        parts.append('<div class="measured">' + table(
            ["Figure", "Measured", "Allowed"],
            [(name, number(figures[key]), number(check["tolerance"][key])) for key, name in BOUNDS.items()]
            + [("Pixels on edges", figures["edge_pixels"], ""), ("RMSE", number(figures["rmse"]), ""),
               ("PSNR, dB", number(figures["psnr"]), "")], f"Figures of {text(check['id'])}") + histogram(check) + "</div>")
        parts.append(zoom(check))
    time = f"{check['milliseconds']:.1f} ms" if "milliseconds" in check else "no time"
    parts.append(f'<dl><dt>Device</dt><dd>{text(device["name"])}, {text(device["platform"])}, driver {text(device["driver"])}</dd>'
                 f'<dt>Time of the frame</dt><dd>{time}</dd><dt>Checked</dt><dd>{text(check["when"])}</dd>'
                 f'<dt>Run again</dt><dd><code>{text(rerun)}</code></dd>'
                 f'<dt>Draw the golden anew</dt><dd><code>{text(update)}</code></dd></dl>')
    verdict = "failed" if check["failure"] else "passed"
    return (f'<article id="{text(check["id"])}" class="{verdict}"><details{" open" if check["failure"] else ""}><summary>'
            f'<h3>{text(check["scene"])} on {text(device["platform"])}</h3> <span class="verdict">{verdict}</span></summary>'
            + "".join(parts) + "</details></article>")


def overview(checks):
    rows = []
    for check in checks:
        figures = check.get("figures", {})
        rows.append((f'<a href="#{text(check["id"])}">{text(check["scene"])}</a>', text(check["device"]["platform"]),
                     f'<span class="verdict {"failed" if check["failure"] else "passed"}">'
                     f'{"failed" if check["failure"] else "passed"}</span>',
                     *(number(figures.get(key)) for key in ("rmse", "interior")), number(check["tolerance"]["interior"]),
                     f"{check['milliseconds']:.1f}" if "milliseconds" in check else "none"))
    return table(["Scene", "OpenCL", "Verdict", "RMSE", "Worst interior", "Allowed", "ms a frame"], rows, "All checks")


def scatter(checks):
    """Time across and error up, a mark for each check; the table below has the same figures."""
    points = [(c["milliseconds"], max(c["figures"]["rmse"], SMALLEST), c) for c in checks
              if "figures" in c and "milliseconds" in c and math.isfinite(c["figures"]["rmse"])]
    if not points:
        return ""
    platforms = sorted({c["device"]["platform"] for _, _, c in points})
    ranges = [(math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)) + 1e-9))
              for values in ([x for x, _, _ in points], [y for _, y, _ in points])]
    (left, right), (low, high) = ((a, max(b, a + 1)) for a, b in ranges)

    def across(x):
        return 60 + 560 * (math.log10(x) - left) / (right - left)

    def up(y):
        return 260 - 240 * (math.log10(y) - low) / (high - low)

    marks = ["M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0", "M0 -6L6 0L0 6L-6 0Z", "M-5 -5H5V5H-5Z", "M0 -6L6 5H-6Z"]
    drawn = "".join(f'<line x1="{across(10**e):.1f}" y1="20" x2="{across(10**e):.1f}" y2="260"/>'
                    f'<text x="{across(10**e):.1f}" y="280">{10**e:g} ms</text>' for e in range(left, right + 1))
    drawn += "".join(f'<line x1="60" y1="{up(10**e):.1f}" x2="620" y2="{up(10**e):.1f}"/>'
                     f'<text x="30" y="{up(10**e) + 4:.1f}">1e{e}</text>' for e in range(low, high + 1))
    for x, y, check in points:
        mark = marks[platforms.index(check["device"]["platform"]) % len(marks)]
        drawn += (f'<path class="{"failed" if check["failure"] else "passed"}" d="{mark}" '
                  f'transform="translate({across(x):.1f} {up(y):.1f})"><title>{text(check["scene"])}, '
                  f'{text(check["device"]["platform"])}: {x:.1f} ms, RMSE {number(y)}</title></path>')
    for i, platform in enumerate(platforms):
        drawn += (f'<path d="{marks[i % len(marks)]}" transform="translate({80 + 280 * i} 300)"/>'
                  f'<text class="name" x="{92 + 280 * i}" y="304">{text(platform)}</text>')
    said = "Time of a frame across and RMSE up, both axes logarithmic; a mark for each check, by the table below."
    return (f'<figure class="scatter"><svg viewBox="0 0 670 314" role="img" aria-label="{said}">{drawn}</svg>'
            f"<figcaption>{said} Those that failed are hollow.</figcaption></figure>")


def povray_table(file):
    if not file.exists():
        return "<p>Not run yet: <code>./stagelight povray</code></p>"
    scenes = json.loads(file.read_text(encoding="utf-8"))
    rows = [(text(name), f'<span class="verdict {"failed" if s["failure"] else "passed"}">'
             f'{"differs" if s["failure"] else "agrees"}</span>', number(s["worst_interior"]), s["edge_outliers"],
             s["strays"], s["edge_pixels"], number(s["mean_signed_error"]), number(s["rmse"]), text(s["failure"]))
            for name, s in scenes.items()]
    agree = sum(not s["failure"] for s in scenes.values())
    return (f"<p>{agree} of {len(scenes)} scenes agree with the reference within what <code>golden/tolerances.toml</code> "
            "allows; docs/pov-ray.md explains where the two differ.</p>"
            + table(["Scene", "Verdict", "Worst interior", "Edge outliers", "Strays", "Pixels on edges",
                     "Mean signed error", "RMSE", "What differs"], rows, "Scenes as POV-Ray draws them"))


def kill_table(file):
    if not file.exists():
        return "<p>Not run yet: <code>./stagelight mutate</code></p>"
    mutants = json.loads(file.read_text(encoding="utf-8"))
    mutants.sort(key=lambda mutant: bool(mutant["caught"]))
    caught = sum(bool(mutant["caught"]) for mutant in mutants)
    rows = [(f"<code>{text(m['name'])}</code>", text(m["mistake"]), text(m["stage"]),
             f"caught by {len(m['caught'])}: <code>{text(m['caught'][0])}</code>" if m["caught"]
             else '<span class="verdict failed">survives its stage</span>') for m in mutants]
    return (f"<p>{caught} of {len(mutants)} mistakes that were planted are caught by the checks of their stage.</p>"
            + table(["Mistake", "What is wrong", "Stage", "Verdict"], rows, "Mistakes that were planted"))


def chart(out, folder):
    file = out / "chart" / "chart.svg"
    if not file.exists():
        return "<p>Not drawn yet: <code>./stagelight chart</code></p>"
    shutil.copyfile(file, folder / "chart.svg")
    return ('<img class="chart" src="chart.svg" alt="Time against error of every method, a panel for each scene; '
            'out/chart/index.html has the figures in a table">')


def read_checks(results):
    checks = []
    for file in sorted(results.glob("*.json")):
        check = json.loads(file.read_text(encoding="utf-8"))
        checks.append({"id": f"Stage{file.stem}", "pictures": {}} | check)
    if not checks:
        fail("nothing was run yet: ./stagelight test -L golden, or ./stagelight golden for the default device alone")
    checks.sort(key=lambda check: not check["failure"])  # failures first
    return checks


def write_page(checks, results, out, folder):
    for check in checks:
        for name in check["pictures"].values():
            shutil.copyfile(results / name, folder / name)
    failed = [check for check in checks if check["failure"]]
    passed = checks[len(failed):]
    devices = sorted({f"{c['device']['platform']}: {c['device']['name']}, {c['device']['version']}, driver "
                      f"{c['device']['driver']}" for c in checks})
    times = sorted(check["when"] for check in checks)
    parts = {
        "VERDICT": f"{len(failed)} of {len(checks)} checks failed" if failed else f"All {len(checks)} checks passed",
        "STATE": "failed" if failed else "passed",
        "DEVICES": "".join(f"<li>{text(device)}</li>" for device in devices),
        "WHEN": text(f"Checked from {times[0]} to {times[-1]}"),
        "FAILED": "".join(map(article, failed)) or "<p>None.</p>",
        "PASSED": "".join(map(article, passed)) or "<p>None.</p>",
        "OVERVIEW": scatter(checks) + overview(checks),
        "KILLS": kill_table(out / "mutants.json"),
        "POVRAY": povray_table(out / "povray.json"),
        "CHART": chart(out, folder),
        "CROP": CROP, "SCALE": SCALE,
    }
    page = (pathlib.Path(__file__).parent / "page.html").read_text(encoding="utf-8")
    for key, value in parts.items():
        page = page.replace(f"@{key}@", str(value))
    (folder / "index.html").write_text(page, encoding="utf-8")
    return parts["VERDICT"]


def main():
    results, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    checks = read_checks(results)
    fresh = out / "report.new"
    shutil.rmtree(fresh, ignore_errors=True)
    try:
        fresh.mkdir(parents=True)
        verdict = write_page(checks, results, out, fresh)
        shutil.rmtree(out / "report", ignore_errors=True)
        fresh.rename(out / "report")
    except OSError as error:
        shutil.rmtree(fresh, ignore_errors=True)
        fail(error)
    print(f"{verdict}; wrote {out / 'report' / 'index.html'}")


main()
