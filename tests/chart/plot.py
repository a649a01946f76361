# SPDX-License-Identifier: MIT
"""plot.py FOLDER CHART_JS: draws what `chart` measured (FOLDER/chart.json) as SVG and PNG, for reading, and as
pages to point at, which hold the charting library and ask no other address for anything."""
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend comes first)

SMALLEST = 1e-9  # an error of 0 has no place on a logarithmic axis
COLORS = plt.get_cmap("tab20").colors


def kinds_of(charts):
    kinds = []
    for chart in charts:
        for point in chart["points"]:
            if point["kind"] not in kinds:
                kinds.append(point["kind"])
    return kinds


def front_of(points):
    """Of the points of one kind, those that none betters, from fast to slow."""
    return sorted((p for p in points if p["front"]), key=lambda p: p["ratio"])


def stands_apart(point, points):
    """Whether it is far enough from the default of its kind to have its name beside it."""
    default = next((p for p in points if p["default"]), points[0])
    return (abs(math.log(point["ratio"] / default["ratio"])) > 0.05
            or point["rmse"] > 1.3 * default["rmse"] + SMALLEST or default["rmse"] > 1.3 * point["rmse"] + SMALLEST)


def draw_scene(axes, chart, kinds):
    """Time across, error up, a line through the front of each choice."""
    for index, kind in enumerate(kinds):
        points = [p for p in chart["points"] if p["kind"] == kind]
        if not points:
            continue
        color = COLORS[index % len(COLORS)]
        front = front_of(points)
        axes.plot([p["ratio"] for p in front], [max(p["rmse"], SMALLEST) for p in front], "-", color=color, linewidth=1)
        for p in points:
            at = (p["ratio"], max(p["rmse"], SMALLEST))
            axes.plot(*at, "D" if p["default"] else "o", color=color, markersize=6, markeredgecolor="black",
                      markeredgewidth=0.4, label=kind if p is points[0] else None)
            if stands_apart(p, points):
                axes.annotate(f"{kind}={p['name']}", at, fontsize=5, xytext=(3, 2), textcoords="offset points")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.axvline(1, color="gray", linewidth=0.5)
    axes.set_title(f"{chart['name']}, {chart['size'][0]}x{chart['size'][1]}, defaults {chart['milliseconds']:.1f} ms",
                   fontsize=9)
    axes.set_xlabel("time / time of the defaults", fontsize=8)
    axes.set_ylabel("RMSE, linear light", fontsize=8)
    axes.tick_params(labelsize=7)
    axes.grid(alpha=0.3)


def save(figure, folder, name):
    for ending in ("svg", "png"):
        figure.savefig(folder / f"{name}.{ending}", dpi=110)
    plt.close(figure)


def draw(report, folder, kinds):
    charts = report["scenes"]
    for chart in charts:
        figure, axes = plt.subplots(figsize=(10, 7), layout="constrained")
        draw_scene(axes, chart, kinds)
        axes.legend(fontsize=7, loc="best")
        figure.suptitle(f"{report['device']['name']}: diamonds are the defaults", fontsize=9)
        save(figure, folder, chart["name"])
    columns = min(2, len(charts))
    rows = math.ceil(len(charts) / columns)
    figure, all_axes = plt.subplots(rows, columns, figsize=(8 * columns, 5.5 * rows), layout="constrained",
                                    squeeze=False)
    for axes in all_axes.flat[len(charts):]:
        axes.axis("off")
    for axes, chart in zip(all_axes.flat, charts):
        draw_scene(axes, chart, kinds)
    handles = [plt.Line2D([], [], color=COLORS[i % len(COLORS)], marker="o", label=kind)
               for i, kind in enumerate(kinds)]
    figure.legend(handles=handles, loc="lower center", ncols=9, fontsize=8)
    figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))
    figure.suptitle(f"{report['device']['name']}: diamonds are the defaults", fontsize=11)
    save(figure, folder, "chart")


def write_page(report, charts, kinds, library, file, title):
    template = (pathlib.Path(__file__).parent / "page.html").read_text(encoding="utf-8")
    data = {"device": report["device"], "scenes": charts, "kinds": kinds, "smallest": SMALLEST,
            "colors": [matplotlib.colors.to_hex(c) for c in COLORS],
            "pages": ["index"] + [chart["name"] for chart in report["scenes"]]}
    page = template.replace("@TITLE@", title)
    page = page.replace("@LIBRARY@", library.replace("</script", "<\\/script"))
    page = page.replace("@DATA@", json.dumps(data).replace("</", "<\\/"))
    file.write_text(page, encoding="utf-8")


def main():
    folder = pathlib.Path(sys.argv[1])
    library = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
    report = json.loads((folder / "chart.json").read_text(encoding="utf-8"))
    kinds = kinds_of(report["scenes"])
    draw(report, folder, kinds)
    write_page(report, report["scenes"], kinds, library, folder / "index.html", "All scenes")
    for chart in report["scenes"]:
        write_page(report, [chart], kinds, library, folder / f"{chart['name']}.html", chart["name"])
    print(f"wrote {folder}/index.html, chart.svg and chart.png, and the same for each scene")


main()
