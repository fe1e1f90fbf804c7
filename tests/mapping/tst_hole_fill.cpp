#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <QTest>

#include "core/mapping/hole_fill.h"
#include "tests/suite/suite.h"

Q_DECLARE_METATYPE(usar::mapping::Raster)

namespace tst_hole_fill {

using namespace usar;
using namespace usar::mapping;

constexpr double cell_m = 0.25;

namespace {

/// A raster as a drawing, a line of text a row: "." is open ground at 0 m, "#" a crown at 5 m, "/" ground that rises
/// by a meter per meter of x, and anything else unknown.
Raster drawn(const std::vector<std::string>& rows) {
    Raster raster{static_cast<std::int64_t>(rows.front().size()),
                  static_cast<std::int64_t>(rows.size()),
                  cell_m,
                  Vec2::Zero(),
                  {}};
    for (const std::string& row : rows)
        for (std::size_t column = 0; column < row.size(); ++column)
            raster.heights_m.push_back(row[column] == '.'   ? 0.0f
                                       : row[column] == '#' ? 5.0f
                                       : row[column] == '/' ? static_cast<float>(double(column) * cell_m)
                                                            : std::numeric_limits<float>::quiet_NaN());
    return raster;
}

float at(const Raster& raster, std::size_t column, std::size_t row) {
    return raster.heights_m[row * static_cast<std::size_t>(raster.columns) + column];
}

/// A square of open ground with a square of unknown cells in its middle.
Raster withHole(std::size_t side) {
    std::vector<std::string> rows(side + 2, std::string(side + 2, '.'));
    for (std::size_t row = 1; row <= side; ++row)
        rows[row].replace(1, side, side, ' ');
    return drawn(rows);
}

} // namespace

class tst_HoleFill : public QObject {
    Q_OBJECT
private slots:
    void fillsWhatIsEnclosedAndSmall_data() {
        QTest::addColumn<Raster>("raster");
        QTest::addColumn<int>("filled");
        QTest::newRow("nothing is unknown") << drawn({"...", "...", "..."}) << 0;
        QTest::newRow("a cell") << drawn({"...", ". .", "..."}) << 1;
        QTest::newRow("two holes") << drawn({".....", ". . .", "....."}) << 2;
        QTest::newRow("at the border") << drawn({". .", "...", "..."}) << 0;
        QTest::newRow("open to the border by a corner") << drawn({". ...", ".. ..", "....."}) << 0;
        QTest::newRow("cells that touch by a corner") << drawn({"....", ". ..", ".. .", "...."}) << 2;
        QTest::newRow("nearly a square meter") << withHole(3) << 9;
        QTest::newRow("a square meter") << withHole(4) << 0;
        QTest::newRow("an empty raster") << Raster{0, 0, cell_m, Vec2::Zero(), {}} << 0;
    }
    void fillsWhatIsEnclosedAndSmall() {
        QFETCH(Raster, raster);
        QFETCH(int, filled);
        const FilledRaster result = withHolesFilled(raster);
        QCOMPARE(result.filled_cells, std::size_t(filled));
        QCOMPARE(result.filled_m2(), filled * cell_m * cell_m);
        QCOMPARE(holes_m2(raster), result.filled_m2());
        QCOMPARE(result.heights.knownCellCount(), raster.knownCellCount() + std::size_t(filled));
    }

    void theMaskTellsMeasuredFromFilledAndUnknown() {
        const FilledRaster result = withHolesFilled(drawn({"... ", ". ..", "...."}));
        QCOMPARE(at(result.mask, 0, 0), 0.0f);
        QCOMPARE(at(result.mask, 1, 1), 1.0f);
        QVERIFY(std::isnan(at(result.mask, 3, 0)));
        QVERIFY(std::isnan(at(result.heights, 3, 0)));
    }

    void whatWasMeasuredStays() {
        const Raster raster = drawn({"####", ".  #", "...#"});
        const FilledRaster result = withHolesFilled(raster);
        for (std::size_t i = 0; i < raster.heights_m.size(); ++i)
            if (!std::isnan(raster.heights_m[i]))
                QCOMPARE(result.heights.heights_m[i], raster.heights_m[i]);
    }

    void risesWithASlope() {
        const FilledRaster result = withHolesFilled(drawn({"//////", "//  //", "//  //", "//////"}));
        for (const std::size_t column : {2, 3})
            for (const std::size_t row : {1, 2})
                QVERIFY(std::abs(at(result.heights, column, row) - float(double(column) * cell_m)) < 0.06f);
    }

    void takesOneOfTwoFloorsAtAnEdge() {
        // Next to the crown a cell is a crown, next to the ground it is ground.
        const FilledRaster result = withHolesFilled(drawn({"........", "..   ###", "..   ###", "..######"}));
        for (std::size_t column = 2; column < 5; ++column)
            for (const std::size_t row : {1, 2}) {
                const float height_m = at(result.heights, column, row);
                QVERIFY2(height_m == 0.0f || height_m == 5.0f, qPrintable(QString::number(double(height_m))));
            }
        QCOMPARE(at(result.heights, 2, 1), 0.0f);
        QCOMPARE(at(result.heights, 4, 2), 5.0f);
    }
};

USAR_TEST(tst_HoleFill)

} // namespace tst_hole_fill

#include "tst_hole_fill.moc"
