// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Centrelines and fibres as curves: BCC (the binary curve collection of Cem Yuksel, cemyuksel.com) and USDA
// BasisCurves. Both in mm with z out of the top face.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/export_private.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

/// Half the mean of width and height of a yarn of this type at a crossing.
double yarn_radius(const YarnType& type) { return std::sqrt(type.area / pi); }

/// "r 0.0102-0.0147 mm": a BCC has no widths, and readers show the remark.
std::string radius_remark(const ExportJob& job)
{
    double least = std::numeric_limits<double>::max(), most = 0;
    const auto meet = [&](double radius) {
        least = std::min(least, radius);
        most = std::max(most, radius);
    };
    const bool hairs = job.options.mesh.flyaways && job.textile.flyaway.hair_density_per_mm > 0 && job.textile.flyaway.hair_length_mm > 0;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (const YarnType& type : job.textile.system(kind).types) {
            meet(job.lines() ? yarn_radius(type) : drawn_fibre_radius(type));
            if (!job.lines() && type.core > 0) meet(drawn_core_radius(type));
            if (!job.lines() && hairs) meet(metre_from_um(type.fibre.fibre_radius_um));
        }
    const std::string from = fmt::format("{:.5f}", 1e3 * least), to = fmt::format("{:.5f}", 1e3 * most);
    return fmt::format("mm; {} radius {}{}", job.lines() ? "yarn" : "fibre", from, from == to ? "" : "-" + to);
}

/// Text is collected and handed on in large pieces.
class Text {
public:
    explicit Text(OutputRun& run) : run_(run) {}
    void add(std::string_view text)
    {
        text_.append(text);
        spill(1 << 20);
    }
    void whole(std::uint64_t value) { append_whole(text_, value); }
    void decimal(double value, int decimals) { append_decimal(text_, value, decimals); }
    /// "(x, y, z)"
    void triple(double x, double y, double z, int decimals)
    {
        text_ += '(';
        decimal(x, decimals);
        text_ += ", ";
        decimal(y, decimals);
        text_ += ", ";
        decimal(z, decimals);
        add(")");
    }
    void spill(std::size_t most)
    {
        if (text_.size() < most) return;
        run_.add(text_);
        text_.clear();
    }

private:
    OutputRun& run_;
    std::string text_;
};

void color(Text& text, const Color& color) { text.triple(linear_light(color.red), linear_light(color.green), linear_light(color.blue), 5); }

void usda_yarn(const ExportJob& job, const YarnCurves& yarn, Text& text)
{
    text.add(fmt::format(
        "    def BasisCurves \"{}\"\n    {{\n"
        "        uniform token type = \"cubic\"\n        uniform token basis = \"catmullRom\"\n        uniform token wrap = \"pinned\"\n"
        "        int[] curveVertexCounts = [",
        yarn_name(yarn.kind, yarn.yarn)));
    for (std::size_t i = 0; i < yarn.points.size(); ++i) {
        if (i > 0) text.add(", ");
        text.whole(yarn.points[i]);
    }
    text.add("]\n        float[] widths = [");
    for (std::size_t i = 0; i < yarn.radii.size(); ++i) {
        if (i > 0) text.add(", ");
        text.decimal(2e3 * yarn.radii[i], 6);
    }
    const double widest = 1e3 * *std::max_element(yarn.radii.begin(), yarn.radii.end());
    double low[3], high[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
        for (std::size_t i = axis; i < yarn.positions.size(); i += 3) {
            least = std::min(least, yarn.positions[i]);
            most = std::max(most, yarn.positions[i]);
        }
        low[axis] = 1e3 * static_cast<double>(least) - widest;
        high[axis] = 1e3 * static_cast<double>(most) + widest;
    }
    text.add("] (\n            interpolation = \"uniform\"\n        )\n        float3[] extent = [");
    text.triple(low[0], low[1], low[2], 5);
    text.add(", ");
    text.triple(high[0], high[1], high[2], 5);
    text.add("]\n        color3f[] primvars:displayColor = [");
    if (job.wet())
        for (std::size_t i = 0; i < yarn.segments.size(); ++i) {
            if (i > 0) text.add(", ");
            color(text, job.color(yarn.kind, yarn.yarn, yarn.segments[i]));
        }
    else
        color(text, job.color(yarn.kind, yarn.yarn, 0));
    text.add(
        fmt::format("] (\n            interpolation = \"{}\"\n        )\n        point3f[] points = [", job.wet() ? "vertex" : "constant"));
    for (std::size_t i = 0; i < yarn.positions.size(); i += 3) {
        if (i > 0) text.add(", ");
        text.triple(1e3 * static_cast<double>(yarn.positions[i]), 1e3 * static_cast<double>(yarn.positions[i + 1]),
                    1e3 * static_cast<double>(yarn.positions[i + 2]), 5);
    }
    text.add("]\n    }\n");
}

} // namespace

CurveCount curve_count(const ExportJob& job, YarnKind kind, int yarn)
{
    MeshRequest middle = job.options.mesh;
    middle.detail = MeshDetail::centreline;
    const std::size_t rings = stream_size(job.textile, middle, kind, yarn).vertices;
    if (job.options.mesh.detail != MeshDetail::fibre) return {1, rings};
    const auto fibres = static_cast<std::size_t>(running_strands(job.textile.type(kind, yarn)));
    const std::size_t hairs =
        YarnFibres::count_hairs(job.textile, job.options.mesh.fibres(), kind, yarn, 0, job.textile.crossings_along(kind));
    return {fibres + hairs, fibres * rings + hairs * YarnFibres::hair_points};
}

void for_each_curves(const ExportJob& job, const std::function<void(const YarnCurves&)>& take)
{
    const auto all = static_cast<double>(job.textile.ends() + job.textile.picks());
    double done = 0;
    tell(job, 0);
    YarnCurves curves;
    for_each_yarn(job.textile, [&](YarnKind kind, int yarn) {
        curves.kind = kind;
        curves.yarn = yarn;
        if (job.lines()) {
            curves.positions = yarn_line(job.textile, kind, yarn, job.options.mesh.samples_per_crossing).positions;
            curves.points = {curves.positions.size() / 3};
            curves.radii = {yarn_radius(job.textile.type(kind, yarn))};
            curves.segments.clear();
            for (std::size_t i = 0; i < curves.points[0]; ++i) curves.segments.push_back(job.segment_of_point(kind, yarn, i));
        } else {
            const YarnFibres fibres(job.textile, job.options.mesh.fibres(), kind, yarn, 0,
                                    kind == YarnKind::warp ? job.textile.picks() : job.textile.ends());
            std::vector<std::size_t> first;
            curves.points.clear();
            curves.radii.clear();
            std::size_t points = 0;
            for (int strand = 0; strand < fibres.strands(); ++strand) {
                first.push_back(points);
                points += fibres.points(strand);
                curves.points.push_back(fibres.points(strand));
                curves.radii.push_back(fibres.radius(strand));
            }
            curves.positions.resize(3 * points);
            curves.segments.resize(points);
            tbb::parallel_for(0, fibres.strands(), [&](int strand) {
                const std::size_t begin = first[strand];
                fibres.curve(strand, &curves.positions[3 * begin]);
                for (std::size_t i = 0; i < fibres.points(strand); ++i) curves.segments[begin + i] = fibres.segment(strand, i);
            });
        }
        take(curves);
        tell(job, ++done / all);
    });
}

double bcc_bytes(const ExportEstimate& size)
{
    return 64.0 + 4.0 * static_cast<double>(size.curves) + 12.0 * static_cast<double>(size.vertices);
}

void write_bcc(const ExportJob& job, const std::filesystem::path& path)
{
    CurveCount all;
    for_each_yarn(job.textile, [&](YarnKind kind, int yarn) {
        const CurveCount one = curve_count(job, kind, yarn);
        all.curves += one.curves;
        all.points += one.points;
    });
    OutputFile file(path, job.shown);
    OutputRun run(file, 0);
    run.add(std::string_view("BCC\x44"
                             "C0\x03\x02",
                             8)); // 4-byte integers and numbers, uniform Catmull-Rom, three dimensions, z up
    run.put(std::uint64_t(all.curves));
    run.put(std::uint64_t(all.points));
    std::string remark = radius_remark(job);
    remark.resize(40, '\0');
    run.add(remark);
    for_each_curves(job, [&](const YarnCurves& yarn) {
        const float* p = yarn.positions.data();
        for (std::size_t points : yarn.points) {
            run.put(static_cast<std::int32_t>(points)); // more than 0: open
            for (std::size_t i = 0; i < 3 * points; ++i) run.put(1000 * *p++);
        }
    });
    run.flush();
    file.close();
}

double usda_bytes(const ExportJob& job, const ExportEstimate& size)
{
    // A point: "(-12.34567, -12.34567, -0.12345), "
    return 700.0 * static_cast<double>(size.yarns) + 15.0 * static_cast<double>(size.curves) +
           (32.0 + (job.wet() ? 29.0 : 0.0)) * static_cast<double>(size.vertices);
}

void write_usda(const ExportJob& job, const std::filesystem::path& path)
{
    OutputFile file(path, job.shown);
    OutputRun run(file, 0);
    Text text(run);
    text.add(
        "#usda 1.0\n(\n    defaultPrim = \"Textile\"\n    doc = \"Hygroloom. Lengths in mm; x along the weft, y along the warp, z out of "
        "the top face.\"\n    metersPerUnit = 0.001\n    upAxis = \"Z\"\n)\n\ndef Xform \"Textile\"\n{\n");
    for_each_curves(job, [&](const YarnCurves& yarn) { usda_yarn(job, yarn, text); });
    text.add("}\n");
    text.spill(1);
    run.flush();
    file.close();
}

} // namespace hygroloom
