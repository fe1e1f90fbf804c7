#include <algorithm>

#include <QTest>

#include "core/agent/mark_style.h"
#include "core/mission/files/map_picture.h"
#include "core/mission/files/relief_picture.h"
#include "tests/mission/files/sample_scan.h"
#include "tests/suite/suite.h"

namespace tst_relief_picture {

using namespace usar;
using namespace usar::mission;
using agent::MarkKind;

namespace {

int pixelsOf(const QImage& picture, std::uint32_t rgb) {
    int found = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            found += (picture.pixel(x, y) & 0xffffffu) == (rgb & 0xffffffu) ? 1 : 0;
    return found;
}

int differentPixels(const QImage& a, const QImage& b) {
    int different = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            different += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return different;
}

} // namespace

class tst_ReliefPicture : public QObject {
    Q_OBJECT
private slots:
    void showsWhatTheMissionLeft_data() {
        QTest::addColumn<int>("part");
        QTest::newRow("heights") << 0;
        QTest::newRow("path") << 1;
        QTest::newRow("marks") << 2;
        QTest::newRow("area") << 3;
    }

    /// Without one of its parts the picture is another one.
    void showsWhatTheMissionLeft() {
        QFETCH(int, part);
        ScanRecord record = sampleScan(60);
        const QImage whole = reliefPicture(record);
        QCOMPARE(whole.size(), QSize(1600, 1000));
        switch (part) {
        case 0:
            std::ranges::transform(record.raster.heights_m, record.raster.heights_m.begin(),
                                   [](float height_m) { return 1.5f * height_m; });
            break;
        case 1:
            QVERIFY(pixelsOf(whole, agent::styleOf(MarkKind::Path).rgb) > 100);
            record.path_m.clear();
            break;
        case 2:
            record.marks.clear();
            break;
        default:
            record.area_in_map = {};
        }
        QVERIFY(differentPixels(whole, reliefPicture(record)) > 200);
    }

    void hasTheLookOfTheMap() {
        const ScanRecord record = sampleScan(60);
        const QImage colored = reliefPicture(record), gray = reliefPicture(record, {mapping::ColorMap::Gray});
        QVERIFY(differentPixels(colored, gray) > 100000);
        QVERIFY(differentPixels(colored, reliefPicture(record, {mapping::ColorMap::Color,
                                                                mapping::HeightRange{-100.0f, 100.0f}})) > 100000);
    }

    void anEmptyMapHasNoPicture() {
        QVERIFY(reliefPicture(ScanRecord{}).isNull());
        ScanRecord unknown = sampleScan(10);
        std::ranges::fill(unknown.raster.heights_m, std::nanf(""));
        QCOMPARE(reliefPicture(unknown).size(), QSize(1600, 1000));
    }

    void carriesItsMetadata() {
        const ScanRecord record = sampleScan(20);
        const QImage picture = reliefPicture(record);
        for (const auto& [key, value] : metadataOf(record))
            QCOMPARE(picture.text(key), value);
    }

    void aCanceledExportHasNoPicture() {
        std::stop_source source;
        const ScanRecord record = sampleScan(20);
        QVERIFY(!reliefPicture(record, {}, source.get_token()).isNull());
        source.request_stop();
        QVERIFY(reliefPicture(record, {}, source.get_token()).isNull());
    }

    void thePathIsBrokenWhereItJumps_data() {
        QTest::addColumn<double>("step_m");
        QTest::addColumn<bool>("shown");
        QTest::newRow("steps") << 9.0 << true;
        QTest::newRow("jumps") << 11.0 << false;
    }

    void thePathIsBrokenWhereItJumps() {
        QFETCH(double, step_m);
        QFETCH(bool, shown);
        ScanRecord record = sampleScan(240); // 60 m wide
        record.path_m.clear();
        for (int i = -2; i <= 2; ++i)
            record.path_m.push_back({i * step_m, 0.0, 12.0}); // above all hills and trees
        const std::uint32_t color = agent::styleOf(MarkKind::Path).rgb;
        const int with_path = pixelsOf(reliefPicture(record), color);
        record.path_m.clear();
        const int without = pixelsOf(reliefPicture(record), color);
        QCOMPARE(with_path > without + 100, shown);
        QVERIFY(shown || with_path == without);
    }
};

USAR_TEST(tst_ReliefPicture)

} // namespace tst_relief_picture

#include "tst_relief_picture.moc"
