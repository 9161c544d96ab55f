// Plots as SVG text, without a library: axes, lines, coloured cells.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {
namespace {

constexpr double kWidth = 820, kHeight = 440, kLeft = 130, kRight = 170, kTop = 44, kBottom = 56;
constexpr const char* kColors[] = {"#2f5d8a", "#b23a2e", "#4e7a36", "#c9a227", "#6b4c8a", "#3c7271"};

/// An axis over the values with ticks at round numbers; logarithmic, by decades, if all are positive and span more than
/// a factor of 50.
struct Axis {
    double low = 0.0, high = 1.0, from = 0.0, to = 1.0;
    bool logarithmic = false;
    std::vector<double> ticks;
    void fit(const std::vector<double>& values, double fromPixel, double toPixel, bool mayBeLogarithmic = true) {
        low = *std::min_element(values.begin(), values.end());
        high = *std::max_element(values.begin(), values.end());
        from = fromPixel, to = toPixel;
        logarithmic = mayBeLogarithmic && low > 0.0 && high > 50.0 * low;
        if (logarithmic) {
            low = std::pow(10.0, std::floor(std::log10(low) + 1e-9)),
            high = std::pow(10.0, std::ceil(std::log10(high) - 1e-9));
            for (double tick = low; tick <= high * 1.001; tick *= 10.0) ticks.push_back(tick);
            return;
        }
        low = std::min(low, 0.0);
        if (high <= low) high = low + 1.0;
        const double rough = (high - low) / 5.0, decade = std::pow(10.0, std::floor(std::log10(rough)));
        const double step = decade * (rough > 5 * decade ? 10 : rough > 2 * decade ? 5 : rough > decade ? 2 : 1);
        low = std::floor(low / step) * step, high = std::ceil(high / step - 1e-9) * step;
        for (int i = 0; low + i * step <= high + 0.001 * step; ++i) ticks.push_back(low + i * step);
    }
    double shareOf(double v) const {
        return logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
    }
    double at(double v) const { return from + (to - from) * shareOf(v); }
};

std::string text(double x, double y, const std::string& words, const char* anchor = "middle", double turn = 0.0) {
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" transform=\"rotate({} {:.1f} {:.1f})\">{}</text>\n", x, y,
        anchor, turn, x, y, words);
}

std::string frame(const Options& options, const std::string& title, const std::string& xLabel,
                  const std::string& yLabel) {
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" "
        "font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        kWidth, kHeight);
    out +=
        fmt::format("<text x=\"{}\" y=\"20\" text-anchor=\"middle\" font-size=\"14\">{}</text>\n", kWidth / 2, title);
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"7\" fill=\"#777\">{}</text>\n",
                       kWidth / 2, kHeight - 5, stamp(options));
    out += text((kLeft + kWidth - kRight) / 2, kHeight - 18, xLabel) +
           text(16, (kTop + kHeight - kBottom) / 2, yLabel, "middle", -90);
    return out;
}

std::string grid(const Axis& axis, bool isUpright) {
    std::string out;
    for (const double tick : axis.ticks) {
        const double at = axis.at(tick);
        out += isUpright ? fmt::format("<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/>\n", kLeft, at, kWidth - kRight)
                         : fmt::format("<path d=\"M{:.1f} {}V{}\" stroke=\"#ddd\"/>\n", at, kTop, kHeight - kBottom);
        const std::string number = fmt::format("{:.4g}", std::abs(tick) < 1e-12 ? 0.0 : tick);
        out += isUpright ? text(kLeft - 6, at + 4, number, "end") : text(at, kHeight - kBottom + 14, number);
    }
    return out;
}

std::string legend(size_t line, const std::string& name, const char* color) {
    const double x = kWidth - kRight + 14, y = kTop + 16 * double(line);
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"{}\"/>\n", x, y, color) +
           text(x + 16, y + 9, name, "start");
}

bool write(const Options& options, const std::string& name, const std::string& svg) {
    std::ofstream file(options.out + "/" + name + ".svg");
    file << svg << "</svg>\n";
    return bool(file.flush());
}

}  // namespace

bool writePlot(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel,
               const std::string& yLabel, const std::vector<Series>& series) {
    std::vector<double> xs, ys;
    for (const Series& each : series)
        for (const auto& [x, y] : each.points) xs.push_back(x), ys.push_back(y);
    if (xs.empty()) return true;
    Axis xAxis, yAxis;
    xAxis.fit(xs, kLeft, kWidth - kRight);
    yAxis.fit(ys, kHeight - kBottom, kTop);
    std::string svg = frame(options, title, xLabel, yLabel);
    svg += grid(xAxis, false) + grid(yAxis, true);
    for (size_t s = 0; s < series.size(); ++s) {
        const char* color = kColors[s % std::size(kColors)];
        std::string path;
        for (const auto& [x, y] : series[s].points) {
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", xAxis.at(x), yAxis.at(y));
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", xAxis.at(x), yAxis.at(y),
                               series[s].isMark ? 6 : 3, color);
            if (series[s].isMark) svg += text(xAxis.at(x) + 8, yAxis.at(y) - 6, series[s].name, "start");
        }
        if (!series[s].isCloud && !series[s].isMark)
            svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path, color);
        svg += legend(s, series[s].name, color);
    }
    return write(options, name, svg);
}

Series paretoFront(const std::string& name, std::vector<std::pair<double, double>> all) {
    std::sort(all.begin(), all.end());
    Series front{name, {}};
    for (const auto& point : all)
        if (front.points.empty() || point.second < front.points.back().second) front.points.push_back(point);
    return front;
}

bool writeBars(const Options& options, const std::string& name, const std::string& title, const std::string& yLabel,
               const std::vector<Bar>& bars) {
    std::vector<std::string> groups, names;
    std::vector<double> tops;
    for (const Bar& bar : bars) {
        if (std::find(groups.begin(), groups.end(), bar.group) == groups.end()) groups.push_back(bar.group);
        if (std::find(names.begin(), names.end(), bar.name) == names.end()) names.push_back(bar.name);
        tops.push_back(bar.value.high);
    }
    Axis axis;
    axis.fit(tops, kHeight - kBottom, kTop, false);
    std::string svg = frame(options, title, "", yLabel) + grid(axis, true);
    const double slot = (kWidth - kRight - kLeft) / double(groups.size()), width = 0.8 * slot / double(names.size());
    for (const Bar& bar : bars) {
        const auto group = std::find(groups.begin(), groups.end(), bar.group) - groups.begin(),
                   one = std::find(names.begin(), names.end(), bar.name) - names.begin();
        const double x = kLeft + slot * (double(group) + 0.1) + width * double(one), y = axis.at(bar.value.median);
        svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x, y,
                           width - 1, kHeight - kBottom - y, kColors[size_t(one) % std::size(kColors)]);
        svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#222\"/>\n", x + width / 2,
                           axis.at(bar.value.low), axis.at(bar.value.high));
    }
    for (size_t i = 0; i < groups.size(); ++i)
        svg += text(kLeft + slot * (double(i) + 0.5), kHeight - kBottom + 14, groups[i]);
    for (size_t i = 0; i < names.size(); ++i) svg += legend(i, names[i], kColors[i % std::size(kColors)]);
    return write(options, name, svg);
}

const char* nameOf(Outcome outcome) {
    static constexpr const char* kNames[] = {"stable", "degraded", "failed", "refused"};
    return kNames[size_t(outcome)];
}

bool writeMap(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel,
              const std::string& yLabel, const std::vector<MapCell>& cells, const Meanings& meanings) {
    static constexpr const char* kFill[] = {"#9dbf8a", "#e3c766", "#c9685c", "#c4c4c4"};
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
        svg += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" stroke=\"white\"/>\n", x, y,
            w, h, kFill[size_t(cell.outcome)]);
        const size_t end = std::min(cell.text.find('\n'), cell.text.size());
        const bool hasTwoLines = end < cell.text.size();
        svg += text(x + w / 2, y + h / 2 + (hasTwoLines ? -3 : 4), cell.text.substr(0, end));
        if (hasTwoLines) svg += text(x + w / 2, y + h / 2 + 11, cell.text.substr(end + 1));
    }
    for (size_t i = 0; i < xs.size(); ++i) svg += text(kLeft + w * (double(i) + 0.5), kHeight - kBottom + 14, xs[i]);
    for (size_t i = 0; i < ys.size(); ++i)
        svg += text(kLeft - 6, kHeight - kBottom - h * (double(i) + 0.5) + 4, ys[i], "end");
    for (size_t i = 0; i < meanings.size(); ++i)
        if (meanings[i]) svg += legend(i, meanings[i], kFill[i]);
    return write(options, name, svg);
}

}  // namespace rubble::tradeoff
