#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/figures.h"
#include "widgets/models/preview_text.h"

namespace tst_figures {

using namespace usar;
using namespace usar::widgets;

class tst_Figures : public QObject {
    Q_OBJECT
private slots:
    void writesNumbersForPeople_data();
    void writesNumbersForPeople();
    void keepsItsWidth();
    void writesDurations_data();
    void writesDurations();
    void agesStayShort();
    void tellsATaskBeforeItsStart();
    void tellsWhatATaskWillProbablyTake_data();
    void tellsWhatATaskWillProbablyTake();
};

void tst_Figures::writesNumbersForPeople_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");
    QTest::newRow("plain") << 31.24 << 1 << QStringLiteral("31.2");
    QTest::newRow("true minus") << -8.0 << 1 << QStringLiteral("−8.0");
    QTest::newRow("no negative zero") << -0.04 << 1 << QStringLiteral("0.0");
    QTest::newRow("no decimals") << 1234.0 << 0 << QStringLiteral("1234");
    QTest::newRow("not a number") << qQNaN() << 2 << QStringLiteral("–");
    QTest::newRow("endless") << qInf() << 2 << QStringLiteral("–");
}

void tst_Figures::writesNumbersForPeople() {
    QFETCH(double, value);
    QFETCH(int, decimals);
    QTEST(figure(value, decimals), "text");
}

void tst_Figures::keepsItsWidth() {
    for (const double value : {0.0, -3.25, 999.0, qQNaN()})
        QCOMPARE(figure(value, 2, 7).size(), 7);
    QCOMPARE(figure(1.0, 0, 3), QStringLiteral("\u2007\u20071"));
}

void tst_Figures::writesDurations_data() {
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("clock");
    QTest::addColumn<QString>("words");
    QTest::newRow("zero") << 0.0 << QStringLiteral("00:00:00") << QStringLiteral("0 s");
    QTest::newRow("minutes") << 751.2 << QStringLiteral("00:12:31") << QStringLiteral("12 min 31 s");
    QTest::newRow("hours") << 7384.0 << QStringLiteral("02:03:04") << QStringLiteral("2 h 03 min");
    QTest::newRow("a second short of a minute") << 59.4 << QStringLiteral("00:00:59") << QStringLiteral("59 s");
    QTest::newRow("negative") << -1.0 << QStringLiteral("–") << QStringLiteral("–");
    QTest::newRow("not a number") << qQNaN() << QStringLiteral("–") << QStringLiteral("–");
}

void tst_Figures::writesDurations() {
    QFETCH(double, seconds);
    QTEST(clockText(Seconds(seconds)), "clock");
    QTEST(durationText(Seconds(seconds)), "words");
}

void tst_Figures::agesStayShort() {
    QCOMPARE(ageText(Seconds(0.26)), QStringLiteral("0.3 s"));
    QCOMPARE(ageText(Seconds(-0.1)), QStringLiteral("0.0 s"));
    QCOMPARE(ageText(Seconds(12.4)), QStringLiteral("12 s"));
    QCOMPARE(ageText(Seconds(180.0)), QStringLiteral("3 min"));
    for (double age = 0.0; age < 1e5; age += 7.3)
        QVERIFY2(ageText(Seconds(age)).size() <= 6, qPrintable(ageText(Seconds(age))));
}

void tst_Figures::tellsATaskBeforeItsStart() {
    const QString text = previewText({{}, 2423.6, Seconds(2520.0), "12 lanes in 4 parts"});
    QVERIFY(text.contains(QStringLiteral("42\u00a0min"))); // A line breaks elsewhere.
    QCOMPARE(QString(text).replace(QChar::Nbsp, QChar::Space),
             QStringLiteral("12 lanes in 4 parts · 2424 m · about 42 min 00 s"));
}

void tst_Figures::tellsWhatATaskWillProbablyTake_data() {
    QTest::addColumn<int>("least_sorties");
    QTest::addColumn<int>("most_sorties");
    QTest::addColumn<QString>("text");
    const QString before = QStringLiteral("In the open: 38 min 00 s to 47 min 00 s, ");
    const QString after = QStringLiteral(", 92 to 99 % of the area shown");
    QTest::newRow("one") << 1 << 1 << QString(before + "one sortie" + after);
    QTest::newRow("five") << 5 << 5 << QString(before + "5 sorties" + after);
    QTest::newRow("five or six") << 5 << 6 << QString(before + "5 to 6 sorties" + after);
}

void tst_Figures::tellsWhatATaskWillProbablyTake() {
    QFETCH(int, least_sorties);
    QFETCH(int, most_sorties);
    const agent::TaskOutlook told{{Seconds(2280.0), Seconds(2820.0)}, least_sorties, most_sorties, 92.8, 98.2};
    QTEST(outlookText(told).replace(QChar::Nbsp, QChar::Space), "text");
}

USAR_TEST(tst_Figures)

} // namespace tst_figures

#include "tst_figures.moc"
