#include <cmath>

#include <QAction>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/bars/replay_bar.h"

namespace tst_replay_bar {

using namespace usar;
using namespace usar::widgets;

class tst_ReplayBar : public QObject {
    Q_OBJECT
private slots:
    void saysMomentLengthAndSpeed();
    void aClickGoesThere_data();
    void aClickGoesThere();
    void theSliderFollowsTheHandWhileItIsHeld();
    void keysOnTheSliderAreWishes();
    void speedsAreChosenAndStepped();
    void theBadgeSaysWhatIsWritten();
};

void tst_ReplayBar::saysMomentLengthAndSpeed() {
    ReplayBar bar;
    bar.setState({.position = Seconds{90.0}, .span = Seconds{3600.0}, .speed = 20.0, .playing = true});
    QStringList texts;
    for (const QLabel* label : bar.findChildren<QLabel*>())
        texts << label->text();
    QVERIFY2(texts.contains("00:01:30 / 01:00:00"), qPrintable(texts.join('|')));
    QCOMPARE(bar.findChild<QComboBox*>()->currentText(), QString("20×"));
    QCOMPARE(bar.slider()->value(), 250);
    bar.setState({.position = Seconds{0.0}, .span = Seconds{0.0}, .speed = INFINITY});
    QCOMPARE(bar.findChild<QComboBox*>()->currentText(), QString("max"));
    QCOMPARE(bar.slider()->value(), 0);
}

void tst_ReplayBar::aClickGoesThere_data() {
    QTest::addColumn<double>("part");
    QTest::newRow("a quarter") << 0.25;
    QTest::newRow("the middle") << 0.5;
    QTest::newRow("nearly the end") << 0.9;
}

void tst_ReplayBar::aClickGoesThere() {
    QFETCH(double, part);
    ReplayBar bar;
    bar.resize(800, 40);
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar));
    bar.setState({.position = Seconds{0.0}, .span = Seconds{100.0}});
    QSignalSpy wishes(&bar, &ReplayBar::seekRequested);
    QSlider* slider = bar.slider();
    const int x = static_cast<int>(std::lround(part * slider->width()));
    QTest::mouseClick(slider, Qt::LeftButton, {}, {x, slider->height() / 2});
    QVERIFY(!wishes.isEmpty());
    const double wished_s = wishes.last()[0].value<Seconds>().count();
    QVERIFY2(std::abs(wished_s - 100.0 * part) < 3.0, qPrintable(QString::number(wished_s)));
}

void tst_ReplayBar::theSliderFollowsTheHandWhileItIsHeld() {
    ReplayBar bar;
    bar.resize(800, 40);
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar));
    bar.setState({.position = Seconds{0.0}, .span = Seconds{100.0}});
    QSlider* slider = bar.slider();
    QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
    const int held = slider->value();
    QVERIFY(held > 4000);
    bar.setState({.position = Seconds{1.0}, .span = Seconds{100.0}, .playing = true});
    QCOMPARE(slider->value(), held);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
    bar.setState({.position = Seconds{1.0}, .span = Seconds{100.0}, .playing = true});
    QCOMPARE(slider->value(), 100);
}

void tst_ReplayBar::keysOnTheSliderAreWishes() {
    ReplayBar bar;
    bar.setState({.position = Seconds{50.0}, .span = Seconds{100.0}});
    QSignalSpy wishes(&bar, &ReplayBar::seekRequested);
    QTest::keyClick(bar.slider(), Qt::Key_End);
    QCOMPARE(wishes.size(), 1);
    QCOMPARE(wishes[0][0].value<Seconds>(), Seconds{100.0});
}

void tst_ReplayBar::speedsAreChosenAndStepped() {
    ReplayBar bar;
    bar.setState({.span = Seconds{100.0}, .speed = 1.0});
    QSignalSpy wishes(&bar, &ReplayBar::speedRequested);
    bar.changeSpeed(1);
    bar.changeSpeed(-2);
    bar.changeSpeed(-99);
    bar.changeSpeed(99);
    QList<double> speeds;
    for (const auto& wish : wishes)
        speeds << wish[0].toDouble();
    QCOMPARE(speeds.mid(0, 3), (QList<double>{2.0, 0.5, 0.1}));
    QVERIFY(std::isinf(speeds[3]));
}

void tst_ReplayBar::theBadgeSaysWhatIsWritten() {
    RecordBadge badge;
    QAction action("Record");
    action.setCheckable(true);
    badge.setAction(&action);
    QCOMPARE(badge.text(), QString("not recorded"));
    action.setChecked(true);
    QCOMPARE(badge.text(), QString("REC ready"));
    badge.setState(RecordState{Seconds{75.0}, 3'450'000, "/a/R1.usarrec"});
    QCOMPARE(badge.text(), QString("00:01:15 3.5 MB"));
    badge.setState(RecordState{Seconds{76.0}, 3'560'000, "/a/R1.usarrec"});
    QCOMPARE(badge.text(), QString("00:01:16 3.6 MB"));
    QVERIFY(!badge.toolTip().contains("deleted"));
    badge.setState(RecordState{Seconds{76.0}, 3'560'000, "/a/R1.usarrec", 500'000'000});
    QCOMPARE(badge.text(), QString("00:01:16 3.6 MB"));
    QVERIFY(badge.toolTip().contains("/a/R1.usarrec") && badge.toolTip().contains("at most 500 MB"));
    badge.setState(std::nullopt);
    QCOMPARE(badge.text(), QString("REC ready"));
    action.setChecked(false);
    QCOMPARE(badge.text(), QString("not recorded"));
}

USAR_TEST(tst_ReplayBar)

} // namespace tst_replay_bar

#include "tst_replay_bar.moc"
