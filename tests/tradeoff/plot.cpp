// Plots as SVG text: axes, lines, coloured cells. Small enough to read, and no library for it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {
namespace {

constexpr double kWidth = 640, kHeight = 400, kLeft = 76, kRight = 150, kTop = 44, kBottom = 56;
constexpr const char* kColors[] = {"#2f5d8a", "#b23a2e", "#4e7a36", "#c9a227", "#6b4c8a", "#3c7271"};

/// An axis over the values, logarithmic where they span more than a factor of 50 and none is zero.
struct Axis {
    double low = 0.0, high = 1.0, from = 0.0, to = 1.0;
    bool logarithmic = false;
    void fit(const std::vector<double>& values, double fromPixel, double toPixel) {
        low = *std::min_element(values.begin(), values.end());
        high = *std::max_element(values.begin(), values.end());
        logarithmic = low > 0.0 && high > 50.0 * low;
        if (!logarithmic) low = std::min(low, 0.0);
        if (high <= low) high = low + 1.0;
        from = fromPixel, to = toPixel;
    }
    double shareOf(double v) const { return logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low); }
    double at(double v) const { return from + (to - from) * shareOf(v); }
    double tick(int i) const { return logarithmic ? low * std::pow(high / low, i / 4.0) : low + (high - low) * i / 4.0; }
};

std::string text(double x, double y, const std::string& words, const char* anchor = "middle", double turn = 0.0) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" transform=\"rotate({} {:.1f} {:.1f})\">{}</text>\n", x, y, anchor, turn, x,
                       y, words);
}

std::string frame(const Options& options, const std::string& title, const std::string& xLabel, const std::string& yLabel) {
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" "
        "height=\"100%\" "
        "fill=\"white\"/>\n",
        kWidth, kHeight);
    out += fmt::format("<text x=\"{}\" y=\"20\" text-anchor=\"middle\" font-size=\"14\">{}</text>\n", kWidth / 2, title);
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"7\" fill=\"#777\">{}</text>\n", kWidth / 2, kHeight - 5,
                       stamp(options));
    out += text((kLeft + kWidth - kRight) / 2, kHeight - 18, xLabel) + text(16, (kTop + kHeight - kBottom) / 2, yLabel, "middle", -90);
    return out;
}

bool write(const Options& options, const std::string& name, const std::string& svg) {
    std::ofstream file(options.out + "/" + name + ".svg");
    file << svg << "</svg>\n";
    return bool(file.flush());
}

}  // namespace

bool writePlot(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel, const std::string& yLabel,
               const std::vector<Series>& series) {
    std::vector<double> xs, ys;
    for (const Series& each : series)
        for (const auto& [x, y] : each.points) xs.push_back(x), ys.push_back(y);
    if (xs.empty()) return true;
    Axis xAxis, yAxis;
    xAxis.fit(xs, kLeft, kWidth - kRight);
    yAxis.fit(ys, kHeight - kBottom, kTop);
    std::string svg = frame(options, title, xLabel, yLabel);
    for (int i = 0; i <= 4; ++i) {
        const double x = xAxis.at(xAxis.tick(i)), y = yAxis.at(yAxis.tick(i));
        svg +=
            fmt::format("<path d=\"M{0:.1f} {1}V{2} M{3} {4:.1f}H{5}\" stroke=\"#ddd\"/>\n", x, kTop, kHeight - kBottom, kLeft, y, kWidth - kRight);
        svg += text(x, kHeight - kBottom + 14, fmt::format("{:.3g}", xAxis.tick(i))) +
               text(kLeft - 6, y + 4, fmt::format("{:.3g}", yAxis.tick(i)), "end");
    }
    for (size_t s = 0; s < series.size(); ++s) {
        const char* color = kColors[s % std::size(kColors)];
        std::string path;
        for (const auto& [x, y] : series[s].points) {
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", xAxis.at(x), yAxis.at(y));
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", xAxis.at(x), yAxis.at(y), color);
        }
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path, color);
        const double y = kTop + 10 + 16 * double(s);
        svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"{}\"/>\n", kWidth - kRight + 14, y - 9, color);
        svg += text(kWidth - kRight + 30, y, series[s].name, "start");
    }
    return write(options, name, svg);
}

const char* nameOf(Outcome outcome) {
    static constexpr const char* kNames[] = {"stable", "degraded", "refused"};
    return kNames[size_t(outcome)];
}

bool writeMap(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel, const std::string& yLabel,
              const std::vector<MapCell>& cells) {
    static constexpr const char* kFill[] = {"#9dbf8a", "#e3c766", "#c9685c"};
    std::vector<std::string> xs, ys;
    for (const MapCell& cell : cells) {
        if (std::find(xs.begin(), xs.end(), cell.x) == xs.end()) xs.push_back(cell.x);
        if (std::find(ys.begin(), ys.end(), cell.y) == ys.end()) ys.push_back(cell.y);
    }
    const double w = (kWidth - kRight - kLeft) / double(xs.size()), h = (kHeight - kBottom - kTop) / double(ys.size());
    std::string svg = frame(options, title, xLabel, yLabel);
    for (const MapCell& cell : cells) {
        const double x = kLeft + w * double(std::find(xs.begin(), xs.end(), cell.x) - xs.begin());
        const double y = kHeight - kBottom - h * double(std::find(ys.begin(), ys.end(), cell.y) - ys.begin() + 1);
        svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" stroke=\"white\"/>\n", x, y, w, h,
                           kFill[size_t(cell.outcome)]);
        svg += text(x + w / 2, y + h / 2 + 4, cell.text);
    }
    for (size_t i = 0; i < xs.size(); ++i) svg += text(kLeft + w * (double(i) + 0.5), kHeight - kBottom + 14, xs[i]);
    for (size_t i = 0; i < ys.size(); ++i) svg += text(kLeft - 6, kHeight - kBottom - h * (double(i) + 0.5) + 4, ys[i], "end");
    for (int i = 0; i < 3; ++i) {
        svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"{}\"/>\n", kWidth - kRight + 14, kTop + 16 * i, kFill[i]);
        svg += text(kWidth - kRight + 30, kTop + 9 + 16 * i, nameOf(Outcome(i)), "start");
    }
    return write(options, name, svg);
}

}  // namespace rubble::tradeoff
