// The length of a line on the map, and the heights along it.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/map/measured_line.h"

namespace tst_measured_line {

using namespace usar;
using namespace usar::widgets;

namespace {

const MeasuredLine five_m{Vec2(1.0, 2.0), Vec2(4.0, 6.0)};

/// A slope that rises by 0.5 m a meter along x, known to the right of x = 2 m.
std::optional<double> slope(const Vec2& at_m) {
    return at_m.x() < 2.0 ? std::nullopt : std::optional(0.5 * at_m.x());
}

} // namespace

class tst_MeasuredLine : public QObject {
    Q_OBJECT
private slots:
    void heightsAreLookedUpFromEndToEnd();
    void aLongLineHasBoundedPoints();
    void theRiseIsFromTheFirstToTheLastKnownHeight();
    void theTextSaysLengthHeightsAndRise_data();
    void theTextSaysLengthHeightsAndRise();
    void aRectangleIsSpannedByItsDiagonal_data();
    void aRectangleIsSpannedByItsDiagonal();
};

void tst_MeasuredLine::heightsAreLookedUpFromEndToEnd() {
    std::vector<Vec2> asked;
    const LineProfile profile = profileOf(five_m, 0.25, [&](const Vec2& at_m) {
        asked.push_back(at_m);
        return slope(at_m);
    });
    QCOMPARE(profile.length_m, 5.0);
    QCOMPARE(profile.heights_m.size(), std::size_t(21));
    QVERIFY(asked.front() == five_m.from_m && (asked.back() - five_m.to_m).norm() < 1e-9);
    for (std::size_t i = 1; i < asked.size(); ++i)
        QVERIFY(std::abs((asked[i] - asked[i - 1]).norm() - 0.25) < 1e-9);
    QVERIFY(!profile.heights_m.front() && profile.heights_m.back() == 2.0);
}

void tst_MeasuredLine::aLongLineHasBoundedPoints() {
    const MeasuredLine long_one{Vec2(0, 0), Vec2(1e6, 0)};
    QCOMPARE(profileOf(long_one, 0.1, slope, 500).heights_m.size(), std::size_t(500));
    const MeasuredLine none{Vec2(3, 0), Vec2(3, 0)};
    QCOMPARE(profileOf(none, 0.1, slope).heights_m.size(), std::size_t(2));
}

void tst_MeasuredLine::theRiseIsFromTheFirstToTheLastKnownHeight() {
    const LineProfile profile{3.0, {std::nullopt, 2.0, 5.0, 1.5, std::nullopt}};
    QCOMPARE(profile.rise_m(), std::optional(-0.5));
    QCOMPARE(profile.range_m(), std::optional(std::pair(1.5, 5.0)));
    const LineProfile unknown{3.0, {std::nullopt, std::nullopt}};
    QVERIFY(!unknown.rise_m() && !unknown.range_m());
}

void tst_MeasuredLine::theTextSaysLengthHeightsAndRise_data() {
    QTest::addColumn<QList<double>>("heights_m");
    QTest::addColumn<QString>("text");
    QTest::newRow("up") << QList<double>{1.2, 4.31} << "34.2 m · heights 1.20 … 4.31 m · rises 3.11 m";
    QTest::newRow("down") << QList<double>{4.31, 1.2} << "34.2 m · heights 1.20 … 4.31 m · falls 3.11 m";
    QTest::newRow("unknown") << QList<double>{} << "34.2 m · heights unknown";
}

void tst_MeasuredLine::theTextSaysLengthHeightsAndRise() {
    QFETCH(QList<double>, heights_m);
    QFETCH(QString, text);
    LineProfile profile{34.21, {}};
    for (const double height_m : heights_m)
        profile.heights_m.push_back(height_m);
    QCOMPARE(profileText(profile), text);
}

void tst_MeasuredLine::aRectangleIsSpannedByItsDiagonal_data() {
    QTest::addColumn<QPointF>("from_m");
    QTest::addColumn<QPointF>("to_m");
    QTest::addColumn<bool>("known");
    QTest::addColumn<QString>("text");
    QTest::newRow("up") << QPointF(1, 2) << QPointF(13, 10.5) << true
                        << "12.0 × 8.5 m · 102.0 m² · heights 1.20 … 4.31 m";
    QTest::newRow("down to the left") << QPointF(13, 10.5) << QPointF(1, 2) << true
                                      << "12.0 × 8.5 m · 102.0 m² · heights 1.20 … 4.31 m";
    QTest::newRow("unknown") << QPointF(0, 0) << QPointF(-2, 1) << false << "2.0 × 1.0 m · 2.0 m² · heights unknown";
    QTest::newRow("flat") << QPointF(0, 0) << QPointF(3, 0) << false << "3.0 × 0.0 m · 0.0 m² · heights unknown";
}

void tst_MeasuredLine::aRectangleIsSpannedByItsDiagonal() {
    QFETCH(QPointF, from_m);
    QFETCH(QPointF, to_m);
    QFETCH(bool, known);
    QFETCH(QString, text);
    const MeasuredLine diagonal{{from_m.x(), from_m.y()}, {to_m.x(), to_m.y()}, true};
    QCOMPARE(rectangleText(diagonal.rectangle_in_map(), known ? std::optional(std::pair(1.2, 4.31)) : std::nullopt),
             text);
}

USAR_TEST(tst_MeasuredLine)

} // namespace tst_measured_line

#include "tst_measured_line.moc"
