#include <QAbstractItemView>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"
#include "widgets/messages/command_box.h"
#include "widgets/style/theme.h"

namespace tst_command_box {

using namespace usar;
using namespace usar::widgets;

class tst_CommandBox : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void init();
    void enterSendsTheLine();
    void anEmptyLineIsNotSent();
    void anErrorIsSaidByColumnAndSentOnlyWhenAskedTwice();
    void anUnknownWordIsWarnedOfAndSent();
    void aWordBeingTypedIsNotYetWrong();
    void withoutAConnectionItSaysWhy();
    void tabTakesTheFirstCompletion();
    void keysThatTheOpenListGetsFirstAreTheLines();
    void aCompletionIsChosenWithTheArrows();
    void completedValuesCloseTheirBrace();
    void arrowsWalkThroughTheHistory();
    void historyIsSearchedByWhatIsTyped();
    void historyForgetsTheOldestAndRepeats();
    void wavesStandUnderTheirWord();

private:
    void type(const QString& text) { QTest::keyClicks(box_->line(), text); }
    void press(Qt::Key key) { QTest::keyClick(box_->line(), key); }
    bool popupOpen() const { return box_->completer()->popup()->isVisible(); }

    std::unique_ptr<CommandBox> box_;
    std::unique_ptr<QSignalSpy> sent_;
};

void tst_CommandBox::init() {
    sent_.reset();
    box_ = std::make_unique<CommandBox>();
    sent_ = std::make_unique<QSignalSpy>(box_.get(), &CommandBox::sendRequested);
    box_->setTarget(QStringLiteral("R1"), {});
    box_->resize(600, 60);
    box_->show();
    QVERIFY(QTest::qWaitForWindowExposed(box_.get()));
    box_->line()->setFocus();
}

void tst_CommandBox::enterSendsTheLine() {
    type(QStringLiteral("DRIVE {Left 1.0} {Right 1.0}"));
    press(Qt::Key_Return);
    QCOMPARE(sent_->count(), 1);
    QCOMPARE(sent_->at(0).at(0).toString(), QStringLiteral("DRIVE {Left 1.0} {Right 1.0}"));
    QCOMPARE(box_->line()->text(), QString());
    QCOMPARE(box_->complaint(), QString());
}

void tst_CommandBox::anEmptyLineIsNotSent() {
    type(QStringLiteral("   "));
    press(Qt::Key_Return);
    QCOMPARE(sent_->count(), 0);
}

void tst_CommandBox::anErrorIsSaidByColumnAndSentOnlyWhenAskedTwice() {
    type(QStringLiteral("DRIVE {Left x1}"));
    press(Qt::Key_Return);
    QCOMPARE(sent_->count(), 0);
    QVERIFY2(box_->complaint().contains(QStringLiteral("Column 13: ")), qPrintable(box_->complaint()));
    QVERIFY2(box_->complaint().endsWith(QStringLiteral("Enter again sends it as it is.")),
             qPrintable(box_->complaint()));
    QCOMPARE(box_->line()->diagnostics().size(), 1U);
    press(Qt::Key_Return);
    QCOMPARE(sent_->count(), 1);
    QCOMPARE(sent_->at(0).at(0).toString(), QStringLiteral("DRIVE {Left x1}"));
}

void tst_CommandBox::anUnknownWordIsWarnedOfAndSent() {
    type(QStringLiteral("DRIV {Left 1}"));
    press(Qt::Key_Return);
    QCOMPARE(sent_->count(), 1);
    QVERIFY2(box_->complaint().contains(QStringLiteral("Sent. Column 1: ")), qPrintable(box_->complaint()));
    QVERIFY2(box_->complaint().contains(QStringLiteral("DRIVE")), qPrintable(box_->complaint()));
    type(QStringLiteral("S"));
    QCOMPARE(box_->complaint(), QString());
}

void tst_CommandBox::aWordBeingTypedIsNotYetWrong() {
    type(QStringLiteral("DRIVE {Left 1.0} {Lxq"));
    const test::Beats pauses(500); // in typing, after which it looks
    QVERIFY(test::holdsUntil([&] { return box_->complaint().isEmpty(); }, [&] { return pauses.count() >= 2; }));
    box_->line()->setText(QStringLiteral("DRIVE {Left x} {Right 1.0} "));
    QTRY_VERIFY(box_->complaint().contains(QStringLiteral("Column 13: ")));
}

void tst_CommandBox::withoutAConnectionItSaysWhy() {
    box_->setTarget({}, QStringLiteral("There is no connection. Connect first."));
    type(QStringLiteral("GETSTARTPOSES"));
    press(Qt::Key_Return);
    QCOMPARE(sent_->count(), 0);
    QVERIFY(box_->complaint().contains(QStringLiteral("There is no connection. Connect first.")));
    QCOMPARE(box_->line()->text(), QStringLiteral("GETSTARTPOSES")); // kept for when there is one
}

void tst_CommandBox::tabTakesTheFirstCompletion() {
    type(QStringLiteral("getst"));
    QVERIFY(popupOpen());
    press(Qt::Key_Tab);
    QCOMPARE(box_->line()->text(), QStringLiteral("GETSTARTPOSES "));
    QVERIFY(box_->line()->hasFocus());
}

/// As in a real window, where the open list gets all keys and the line none.
void tst_CommandBox::keysThatTheOpenListGetsFirstAreTheLines() {
    QAbstractItemView* const list = box_->completer()->popup();
    type(QStringLiteral("DRI"));
    QVERIFY(popupOpen());
    QTest::keyClick(list, Qt::Key_Tab);
    QCOMPARE(box_->line()->text(), QStringLiteral("DRIVE "));
    QVERIFY2(box_->line()->hasFocus(), "Tab would have gone to the next control");
    QCOMPARE(sent_->count(), 0);
    box_->line()->clear();
    const QString whole = QStringLiteral("SET {Type Camera}");
    type(whole);
    QTRY_VERIFY(popupOpen());
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(sent_->count(), 1);
    QCOMPARE(sent_->at(0).at(0).toString(), whole);
    QCOMPARE(box_->line()->text(), QString());
}

void tst_CommandBox::aCompletionIsChosenWithTheArrows() {
    type(QStringLiteral("GETG"));
    QVERIFY(popupOpen());
    QTest::keyClick(box_->completer()->popup(), Qt::Key_Down);
    QTest::keyClick(box_->completer()->popup(), Qt::Key_Return);
    QCOMPARE(box_->line()->text(), QStringLiteral("GETGEO "));
    QCOMPARE(sent_->count(), 0);
    QTRY_VERIFY(popupOpen()); // its segments
    QVERIFY(box_->completer()->popup()->model()->rowCount() > 0);
}

void tst_CommandBox::completedValuesCloseTheirBrace() {
    type(QStringLiteral("DRIVE {Normalized t"));
    QVERIFY(popupOpen());
    press(Qt::Key_Tab);
    QCOMPARE(box_->line()->text().toLower(), QStringLiteral("drive {normalized true} "));
}

void tst_CommandBox::arrowsWalkThroughTheHistory() {
    box_->setHistory({QStringLiteral("ONE"), QStringLiteral("TWO")});
    press(Qt::Key_Up);
    QCOMPARE(box_->line()->text(), QStringLiteral("TWO"));
    press(Qt::Key_Up);
    press(Qt::Key_Up); // stays at the oldest
    QCOMPARE(box_->line()->text(), QStringLiteral("ONE"));
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    QCOMPARE(box_->line()->text(), QString());
    press(Qt::Key_Up);
    press(Qt::Key_Return);
    QCOMPARE(sent_->at(0).at(0).toString(), QStringLiteral("TWO"));
}

void tst_CommandBox::historyIsSearchedByWhatIsTyped() {
    box_->setHistory(
        {QStringLiteral("DRIVE {Left 1}"), QStringLiteral("GETCONF {Type Sonar}"), QStringLiteral("STEP")});
    type(QStringLiteral("sonar"));
    press(Qt::Key_Up);
    QCOMPARE(box_->line()->text(), QStringLiteral("GETCONF {Type Sonar}"));
    press(Qt::Key_Up);
    QCOMPARE(box_->line()->text(), QStringLiteral("GETCONF {Type Sonar}"));
    press(Qt::Key_Down);
    QCOMPARE(box_->line()->text(), QStringLiteral("sonar"));
}

void tst_CommandBox::historyForgetsTheOldestAndRepeats() {
    LineHistory history;
    for (int i = 0; i < 250; ++i)
        history.add(QString::number(i));
    history.add(QStringLiteral("100"));
    QCOMPARE(history.lines().size(), LineHistory::limit);
    QCOMPARE(history.lines().front(), QStringLiteral("50"));
    QCOMPARE(history.lines().back(), QStringLiteral("100"));
    QCOMPARE(history.lines().count(QStringLiteral("100")), 1);
}

void tst_CommandBox::wavesStandUnderTheirWord() {
    box_->line()->setText(QStringLiteral("DRIVE {Left 1.0} {Right xyz}"));
    const QImage before = box_->line()->grab().toImage();
    box_->line()->setDiagnostics({{Severity::Error, 24, "no number"}});
    const QImage after = box_->line()->grab().toImage();
    int first = after.width(), last = 0;
    for (int y = 0; y < after.height(); ++y)
        for (int x = 0; x < after.width(); ++x)
            if (before.pixel(x, y) != after.pixel(x, y)) {
                first = std::min(first, x);
                last = std::max(last, x);
            }
    const double letter_px = QFontMetricsF(box_->line()->font()).horizontalAdvance(u'x');
    QVERIFY2(qAbs(first - 24 * letter_px) < 2 * letter_px, qPrintable(QString::number(first)));
    QVERIFY2(qAbs(last - first - 3 * letter_px) < letter_px, qPrintable(QString::number(last - first)));
}

USAR_TEST(tst_CommandBox)

} // namespace tst_command_box

#include "tst_command_box.moc"
