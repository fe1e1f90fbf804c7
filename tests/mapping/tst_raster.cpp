#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/mapping/profile.h"
#include "core/mapping/raster_export.h"
#include "tests/suite/suite.h"

namespace tst_raster {

using namespace usar;
using namespace usar::mapping;

class tst_Raster : public QObject {
    Q_OBJECT
private slots:
    void anEmptyMapIsAnEmptyRaster();
    void isCroppedToTheKnownCellsAndNorthUp();
    void aStrayTileDoesNotFillTheMemory();
    void whatIsTooFarForOneRasterComesInOthers_data();
    void whatIsTooFarForOneRasterComesInOthers();
    void rawBytesAreLittleEndianFloatsWithNoData();
    void headerSaysWhatGdalAsksFor_data();
    void headerSaysWhatGdalAsksFor();
    void profileFollowsTheLine_data();
    void profileFollowsTheLine();
    void profileOfNowhereIsEmpty();
    void courseProfileCountsFromTheRobot_data();
    void courseProfileCountsFromTheRobot();
    void groundBelowIsUnknownOffTheMap();
};

void tst_Raster::anEmptyMapIsAnEmptyRaster() {
    const Raster raster = rasterOf(HeightMap(0.25));
    QVERIFY(raster.empty());
    QVERIFY(!raster.range());
    QCOMPARE(raster.cell_size_m, 0.25);
    QVERIFY(bilBytes(raster).empty());
}

void tst_Raster::isCroppedToTheKnownCellsAndNorthUp() {
    HeightMap map(0.5);
    map.write({-70, -2}, 1.0f, {1});
    map.write({3, 66}, 2.0f, {1});
    map.fill({0, 0}, 3.0f, {1});
    const Raster raster = rasterOf(map);
    QCOMPARE(raster.columns, 74);
    QCOMPARE(raster.rows, 69);
    QVERIFY(raster.upper_left_center_m == Vec2(-34.75, 33.25));
    QCOMPARE(raster.heights_m[68 * 74], 1.0f);
    QCOMPARE(raster.heights_m[73], 2.0f);
    QCOMPARE(raster.heights_m[66 * 74 + 70], 3.0f);
    QCOMPARE(raster.knownCellCount(), std::size_t(3));
    QVERIFY(raster.range() == (HeightRange{1.0f, 3.0f}));
}

void tst_Raster::aStrayTileDoesNotFillTheMemory() {
    HeightMap map(0.25);
    for (std::int32_t i = 0; i < 200; ++i)
        map.write({i, i}, 1.0f, {1});
    map.write(map.cellAt({1e9, -1e9}), 5.0f, {2});
    const Raster raster = rasterOf(map);
    QCOMPARE(raster.columns, 200);
    QCOMPARE(raster.rows, 200);
    QCOMPARE(raster.knownCellCount(), std::size_t(200));
    const std::vector<Raster> all = rastersOf(map);
    QCOMPARE(all.size(), std::size_t(2));
    QCOMPARE(all[1].heights_m, std::vector<float>{5.0f});
    QCOMPARE(all[1].upper_left_center_m, map.center_m(map.cellAt({1e9, -1e9})));
}

void tst_Raster::whatIsTooFarForOneRasterComesInOthers_data() {
    QTest::addColumn<std::vector<GridIndex>>("strays");
    QTest::addColumn<int>("rasters");
    using Cells = std::vector<GridIndex>;
    QTest::newRow("nothing astray") << Cells{} << 1;
    QTest::newRow("beside it, along a row") << Cells{{16000, 0}} << 1;
    QTest::newRow("diagonally, within the side but mostly nothing") << Cells{{12000, 12000}} << 2;
    QTest::newRow("beyond the longest side") << Cells{{17000, 0}} << 2;
    QTest::newRow("two in one place") << Cells{{20000, 20000}, {20100, 20100}} << 2;
    QTest::newRow("all around") << Cells{{20000, 0}, {-20000, 0}, {0, 20000}, {0, -20000}} << 5;
}

void tst_Raster::whatIsTooFarForOneRasterComesInOthers() {
    QFETCH(std::vector<GridIndex>, strays);
    QFETCH(int, rasters);
    HeightMap map(0.25);
    for (std::int32_t i = 0; i < 400; ++i)
        map.write({i, i / 2}, 1.0f, {1});
    for (const GridIndex& stray : strays)
        map.write(stray, 2.0f, {2});
    const std::vector<Raster> all = rastersOf(map);
    QCOMPARE(static_cast<int>(all.size()), rasters);
    std::size_t known = 0;
    for (const Raster& raster : all) {
        known += raster.knownCellCount();
        QVERIFY(raster.columns <= maximum_raster_side && raster.rows <= maximum_raster_side);
        QVERIFY(raster.columns * raster.rows <= roomy_raster_cells);
    }
    QCOMPARE(known, map.knownCellCount()); // nothing is lost
    QVERIFY(all.front().columns >= 400 && all.front().rows >= 200);
    QCOMPARE(rastersOf(map, 1).size(), std::size_t(1));
}

void tst_Raster::rawBytesAreLittleEndianFloatsWithNoData() {
    HeightMap map(1.0);
    map.write({0, 0}, 1.0f, {1});
    map.write({2, 0}, -2.5f, {1});
    const std::vector<char> bytes = bilBytes(rasterOf(map));
    const char expected[] = {0, 0, '\x80', 0x3f, 0, '\x3c', '\x1c', '\xc6', 0, 0, 0x20, '\xc0'};
    QCOMPARE(QByteArray(bytes.data(), qsizetype(bytes.size())), QByteArray(expected, sizeof expected));
}

void tst_Raster::headerSaysWhatGdalAsksFor_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {"BYTEORDER I", "LAYOUT BIL", "NROWS 1", "NCOLS 3", "NBANDS 1", "NBITS 32",
                             "BANDROWBYTES 12", "TOTALROWBYTES 12", "PIXELTYPE FLOAT", "ULXMAP -0.25", "ULYMAP 10.25",
                             "XDIM 0.5", "YDIM 0.5", "NODATA -9999"})
        QTest::newRow(line) << QString(line);
}

void tst_Raster::headerSaysWhatGdalAsksFor() {
    QFETCH(QString, line);
    HeightMap map(0.5);
    map.write({-1, 20}, 1.0f, {1});
    map.write({1, 20}, 2.0f, {1});
    const QStringList lines = QString::fromStdString(bilHeader(rasterOf(map))).split('\n');
    QVERIFY(std::any_of(lines.begin(), lines.end(), [&](const QString& other) { return other.simplified() == line; }));
}

void tst_Raster::profileFollowsTheLine_data() {
    QTest::addColumn<double>("end_x_m");
    QTest::addColumn<double>("end_y_m");
    QTest::addColumn<int>("points");
    QTest::newRow("a point") << 0.25 << 0.25 << 2;
    QTest::newRow("along x") << 5.25 << 0.25 << 11;
    QTest::newRow("diagonal") << 3.25 << 4.25 << 11;
}

void tst_Raster::profileFollowsTheLine() {
    QFETCH(double, end_x_m);
    QFETCH(double, end_y_m);
    QFETCH(int, points);
    HeightMap map(0.5);
    for (std::int32_t column = 0; column < 4; ++column) {
        for (std::int32_t row = 0; row < 20; ++row)
            map.write({column, row}, float(column), {1});
    }
    const Vec2 start_m(0.25, 0.25);
    const Vec2 end_m(end_x_m, end_y_m);
    const std::vector<ProfilePoint> profile = heightProfile(map, start_m, end_m);
    QCOMPARE(static_cast<int>(profile.size()), points);
    QCOMPARE(profile.front().distance_m, 0.0);
    QCOMPARE(profile.back().distance_m, (end_m - start_m).norm());
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Vec2 point_m = start_m + (end_m - start_m) * (double(i) / double(profile.size() - 1));
        QCOMPARE(profile[i].height_m.has_value(), point_m.x() < 2.0);
        if (profile[i].height_m)
            QCOMPARE(*profile[i].height_m, float(std::floor(point_m.x() / 0.5)));
    }
}

void tst_Raster::profileOfNowhereIsEmpty() {
    const HeightMap map(0.5);
    QVERIFY(heightProfile(map, {0, 0}, {qQNaN(), 1}).empty());
    const std::vector<ProfilePoint> long_one = heightProfile(map, {0, 0}, {1e12, 0});
    QCOMPARE(long_one.size(), std::size_t(100'001));
    QVERIFY(!long_one.front().height_m);
}

void tst_Raster::courseProfileCountsFromTheRobot_data() {
    QTest::addColumn<double>("yaw_rad");
    QTest::addColumn<float>("behind_m");
    QTest::addColumn<float>("ahead_m");
    QTest::newRow("east") << 0.0 << 2.0f << 7.0f;
    QTest::newRow("west") << M_PI << 7.0f << 2.0f;
}

void tst_Raster::courseProfileCountsFromTheRobot() {
    QFETCH(double, yaw_rad);
    HeightMap map(0.5);
    for (std::int32_t column = 0; column < 10; ++column)
        map.write({column, 4}, float(column), {1});
    const CourseProfile profile = courseProfile(map, {.position_m = {2.4, 2.2, 9.0}, .yaw_rad = yaw_rad}, 1.25);
    QCOMPARE(profile.points.front().distance_m, -1.25);
    QCOMPARE(profile.points.back().distance_m, 1.25);
    QTEST(profile.points.front().height_m.value(), "behind_m");
    QTEST(profile.points.back().height_m.value(), "ahead_m");
    QCOMPARE(profile.robot_z_m, 9.0);
    QCOMPARE(profile.groundBelow_m(), std::optional(4.0));
}

void tst_Raster::groundBelowIsUnknownOffTheMap() {
    HeightMap map(0.5);
    map.write({0, 0}, 1.0f, {1});
    const Pose near{.position_m = {1.5, 0.2, 5.0}};
    const Pose far{.position_m = {4.0, 0.2, 5.0}};
    QCOMPARE(courseProfile(map, near, 5.0).groundBelow_m(), std::optional(1.0));
    QVERIFY(!courseProfile(map, far, 5.0).groundBelow_m());
    QVERIFY(courseProfile(map, {.position_m = {qQNaN(), 0.0, 5.0}}, 5.0).points.empty());
}

USAR_TEST(tst_Raster)

} // namespace tst_raster

#include "tst_raster.moc"
