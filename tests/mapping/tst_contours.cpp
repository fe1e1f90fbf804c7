// Lines of equal height on small rasters whose lines are known, and on hills, where they must fit together.
#include <QTest>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/mapping/contours.h"
#include "tests/suite/suite.h"

namespace tst_contours {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// Cells of 1 m whose centers are at x = column and y = -row.
Raster rasterFrom(std::int64_t columns, std::vector<float> heights_m) {
    const auto rows = static_cast<std::int64_t>(heights_m.size()) / columns;
    return {columns, rows, 1.0, Vec2::Zero(), std::move(heights_m)};
}

Raster hills(std::int64_t side) {
    std::vector<float> heights_m;
    for (std::int64_t row = 0; row < side; ++row)
        for (std::int64_t column = 0; column < side; ++column)
            heights_m.push_back(
                float(3.0 * std::sin(double(column) / 5.0) * std::cos(double(row) / 7.0) + 0.01 * double(row)));
    return rasterFrom(side, std::move(heights_m));
}

std::string textOf(const Raster& raster) {
    std::string text;
    writeContours(raster, [&text](const char* bytes, std::size_t count) {
        text.append(bytes, count);
        return true;
    });
    return text;
}

/// The height of the raster at a point on a side of a square, between the two cells that it joins.
double heightOnSide(const Raster& raster, const Vec2& point_m) {
    const double row = -point_m.y(), column = point_m.x();
    const auto at = [&](double c, double r) {
        return double(raster.heights_m[std::size_t(r) * std::size_t(raster.columns) + std::size_t(c)]);
    };
    const double c = std::floor(column), r = std::floor(row), part = (column - c) + (row - r);
    return part == 0.0 ? at(c, r) : at(c, r) + part * (at(std::ceil(column), std::ceil(row)) - at(c, r));
}

} // namespace

class tst_Contours : public QObject {
    Q_OBJECT
private slots:
    void smallRastersHaveTheirLines_data() {
        QTest::addColumn<Raster>("raster");
        QTest::addColumn<std::vector<std::vector<Vec2>>>("lines"); // of the height 5
        using Lines = std::vector<std::vector<Vec2>>;
        QTest::newRow("no cells") << Raster{} << Lines{};
        QTest::newRow("one cell") << rasterFrom(1, {7}) << Lines{};
        QTest::newRow("one row") << rasterFrom(3, {0, 10, 0}) << Lines{};
        QTest::newRow("all below") << rasterFrom(2, {0, 1, 2, 3}) << Lines{};
        QTest::newRow("a slope") << rasterFrom(2, {0, 10, 0, 10}) << Lines{{{0.5, 0}, {0.5, -1}}};
        QTest::newRow("a steep one") << rasterFrom(2, {4, 14, 4, 14}) << Lines{{{0.1, 0}, {0.1, -1}}};
        QTest::newRow("a corner") << rasterFrom(2, {10, 0, 0, 0}) << Lines{{{0.5, 0}, {0, -0.5}}};
        QTest::newRow("a hole in a corner") << rasterFrom(2, {0, 10, 0, unknown}) << Lines{};
        QTest::newRow("a saddle with a high middle")
            << rasterFrom(2, {20, 0, 0, 10}) << Lines{{{0.75, 0}, {1, -0.5}}, {{0.5, -1}, {0, -0.75}}};
        QTest::newRow("a saddle with a low middle")
            << rasterFrom(2, {8, 0, 0, 8}) << Lines{{{0, -0.375}, {0.625 - 0.25, 0}}, {{1, -0.625}, {0.625, -1}}};
        QTest::newRow("a peak") << rasterFrom(3, {0, 0, 0, 0, 10, 0, 0, 0, 0})
                                << Lines{{{1, -0.5}, {0.5, -1}, {1, -1.5}, {1.5, -1}, {1, -0.5}}};
        QTest::newRow("a line that ends at a hole")
            << rasterFrom(2, {0, 10, 0, 10, 0, unknown}) << Lines{{{0.5, 0}, {0.5, -1}}};
        QTest::newRow("a plateau at the height")
            << rasterFrom(3, {0, 0, 0, 5, 5, 5, 5, 5, 5}) << Lines{{{0, -1}, {1, -1}, {2, -1}}};
        QTest::newRow("a peak at the height") << rasterFrom(3, {0, 0, 0, 0, 5, 0, 0, 0, 0}) << Lines{};
    }

    void smallRastersHaveTheirLines() {
        QFETCH(Raster, raster);
        QFETCH(std::vector<std::vector<Vec2>>, lines);
        const std::vector<ContourLine> found = contoursAt(raster, 5.0);
        QCOMPARE(found.size(), lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::vector<Vec2> points_m = found[i].points_m;
            const bool closed = points_m.front() == points_m.back();
            QCOMPARE(closed, lines[i].front() == lines[i].back());
            QCOMPARE(points_m.size(), lines[i].size());
            const auto same = [&](const std::vector<Vec2>& a) {
                return std::ranges::equal(a, lines[i],
                                          [](const Vec2& p, const Vec2& q) { return (p - q).norm() < 1e-9; });
            };
            const bool as_told = same(points_m);
            std::ranges::reverse(points_m);
            QVERIFY(as_told || same(points_m));
        }
    }

    void hillsHaveLinesThatFitTogether() {
        const Raster raster = hills(60);
        // Heights that no cell has, because a line through a center has one point for several sides.
        for (const double height_m : {-2.5, -1.0, 0.001, 0.253, 2.0}) {
            const std::vector<ContourLine> lines = contoursAt(raster, height_m);
            QVERIFY(!lines.empty());
            std::size_t crossings = 0; // each once, except for the first point of a closed line
            for (const ContourLine& line : lines) {
                QVERIFY(line.points_m.size() > 1);
                const Vec2 &first_m = line.points_m.front(), &last_m = line.points_m.back();
                const auto onEdge = [](const Vec2& p) {
                    return p.x() == 0.0 || p.y() == 0.0 || p.x() == 59.0 || p.y() == -59.0;
                };
                QVERIFY((first_m == last_m) != (onEdge(first_m) && onEdge(last_m)));
                crossings += line.points_m.size() - (first_m == last_m ? 1 : 0);
                for (std::size_t i = 0; i < line.points_m.size(); ++i) {
                    QVERIFY(std::abs(heightOnSide(raster, line.points_m[i]) - height_m) < 1e-6);
                    QVERIFY(i == 0 || (line.points_m[i] - line.points_m[i - 1]).norm() < 1.5);
                }
            }
            std::size_t sides = 0; // that the height crosses
            const auto above = [&](int c, int r) {
                return double(raster.heights_m[std::size_t(60 * r + c)]) >= height_m;
            };
            for (int r = 0; r < 60; ++r)
                for (int c = 0; c < 60; ++c)
                    sides += std::size_t(c < 59 && above(c, r) != above(c + 1, r)) +
                             std::size_t(r < 59 && above(c, r) != above(c, r + 1));
            QCOMPARE(crossings, sides);
        }
    }

    void theIntervalIsARoundNumberThatFitsTheRange_data() {
        QTest::addColumn<float>("range_m");
        QTest::addColumn<double>("interval_m");
        QTest::newRow("flat") << 0.0f << 0.01;
        QTest::newRow("nearly flat") << 0.1f << 0.01;
        QTest::newRow("a room") << 3.0f << 0.2;
        QTest::newRow("trees") << 16.0f << 1.0;
        QTest::newRow("just twenty") << 20.0f << 1.0;
        QTest::newRow("a little more") << 20.5f << 2.0;
        QTest::newRow("a valley") << 90.0f << 5.0;
        QTest::newRow("mountains") << 1900.0f << 100.0;
    }

    void theIntervalIsARoundNumberThatFitsTheRange() {
        QFETCH(float, range_m);
        QFETCH(double, interval_m);
        const auto interval = contourInterval_m(rasterFrom(2, {0, range_m, unknown, 0}));
        QVERIFY(interval);
        QVERIFY2(std::abs(*interval - interval_m) < 1e-9, qPrintable(QString::number(*interval)));
    }

    void anEmptyRasterHasNoInterval() {
        QVERIFY(!contourInterval_m(Raster{}));
        QVERIFY(!contourInterval_m(rasterFrom(2, {unknown, unknown})));
    }

    void theTextHasAFeatureForEachLine() {
        const Raster raster = hills(40);
        const std::string text = textOf(raster);
        const double interval_m = contourInterval_m(raster).value();
        const HeightRange range = raster.range().value();
        std::size_t lines = 0;
        for (double height_m = -10.0; height_m < 10.0; height_m += interval_m)
            if (height_m > double(range.minimum_m) && height_m < double(range.maximum_m))
                lines += contoursAt(raster, std::round(height_m / interval_m) * interval_m).size();
        QCOMPARE(std::size_t(QString::fromStdString(text).count("\"Feature\"")), lines);
        QVERIFY(lines > 20);
    }

    void aFullDiskStopsTheWriting() {
        int pieces = 0;
        QVERIFY(!writeContours(hills(40), [&](const char*, std::size_t) { return ++pieces < 3; }));
        QCOMPARE(pieces, 3);
    }
};

USAR_TEST(tst_Contours)

} // namespace tst_contours

#include "tst_contours.moc"
