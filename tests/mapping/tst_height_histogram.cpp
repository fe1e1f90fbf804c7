#include <cmath>
#include <vector>

#include <QTest>

#include "core/mapping/height_histogram.h"
#include "tests/suite/suite.h"

namespace tst_height_histogram {

using namespace usar::mapping;

class tst_HeightHistogram : public QObject {
    Q_OBJECT
private slots:
    void leavesOutTwoPercentAtEitherEnd_data();
    void leavesOutTwoPercentAtEitherEnd();
    void withoutHeightsTheRangeIsTheWholeOne();
};

void tst_HeightHistogram::leavesOutTwoPercentAtEitherEnd_data() {
    QTest::addColumn<std::vector<float>>("extremes_m");
    QTest::addColumn<HeightRange>("whole");
    QTest::addColumn<HeightRange>("trimmed");
    const auto times = [](std::size_t count, float height_m) { return std::vector<float>(count, height_m); };
    const HeightRange whole{0.0f, 1024.0f}; // A step is one meter.
    QTest::newRow("one tree") << times(1, 1024.0f) << whole << HeightRange{100.0f, 151.0f};
    QTest::newRow("one pit") << times(1, 0.0f) << whole << HeightRange{100.0f, 151.0f};
    QTest::newRow("a wood") << times(100, 1024.0f) << whole << HeightRange{100.0f, 1024.0f};
    QTest::newRow("unknown cells") << times(1000, std::nanf("")) << whole << HeightRange{100.0f, 151.0f};
    QTest::newRow("beyond the whole range") << times(100, 5000.0f) << whole << HeightRange{100.0f, 1024.0f};
    QTest::newRow("level") << times(10, 100.0f) << HeightRange{100.0f, 100.0f} << HeightRange{100.0f, 100.0f};
}

/// Besides 900 cells of 100 m and 100 of 150 m.
void tst_HeightHistogram::leavesOutTwoPercentAtEitherEnd() {
    QFETCH(std::vector<float>, extremes_m);
    QFETCH(HeightRange, whole);
    HeightHistogram histogram(whole);
    histogram.add(std::vector<float>(900, 100.0f));
    histogram.add(std::vector<float>(100, 150.0f));
    histogram.add(extremes_m);
    QTEST(histogram.trimmed(), "trimmed");
}

void tst_HeightHistogram::withoutHeightsTheRangeIsTheWholeOne() {
    QCOMPARE(HeightHistogram({-3.0f, 7.0f}).trimmed(), (HeightRange{-3.0f, 7.0f}));
}

USAR_TEST(tst_HeightHistogram)

} // namespace tst_height_histogram

#include "tst_height_histogram.moc"
