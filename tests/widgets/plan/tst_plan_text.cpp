#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_places.h"
#include "widgets/plan/plan_text_edit.h"
#include "widgets/style/theme.h"

namespace tst_plan_text {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string faulty = "((C a (elements ((x y))))\n (C a (elements ((x y))))\n (DC d (drives ((e a))))\n (XX))\n";

} // namespace

class tst_PlanText : public QObject {
    Q_OBJECT
private slots:
    void linesAreThoseOfTheReader();
    void spotsBecomeRanges_data();
    void spotsBecomeRanges();
    void columnsCountCodePoints();
    void placesLeadToParts_data();
    void placesLeadToParts();
    void findingsAreMarkedWhereTheyStand();
    void notesAreMarkedBesideTheirLine();
    void spotsBehindTheTextAreMarkedAtItsEnd();
    void f8GoesOverTheFindings();
    void showingAPlaceIsSilent();
    void linesAreSeenFromTheirBeginning();
    void theLineOfTheCursorStaysInViewWhenRoomIsTaken();
    void cursorTellsItsPlace();
    void runningLinesAreTinted();
    void itCannotBeEdited();
    void bothThemesPaint();
};

void tst_PlanText::linesAreThoseOfTheReader() {
    QCOMPARE(editorText("a\r\nb\rc\nd"), QStringLiteral("a\nb c\nd"));
    QCOMPARE(editorText("a\xe2\x80\xa8"
                        "b"),
             QStringLiteral("a b")); // a line separator is none for the reader
    QCOMPARE(editorText(""), QString());
}

void tst_PlanText::spotsBecomeRanges_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("column");
    QTest::addColumn<int>("bytes");
    QTest::addColumn<int>("start");
    QTest::addColumn<int>("length");
    QTest::newRow("plain") << QStringLiteral("(C fetch") << 4 << 5 << 3 << 5;
    QTest::newRow("after an umlaut") << QStringLiteral("\"ü\" fetch") << 5 << 5 << 4 << 5;
    QTest::newRow("after two units") << QStringLiteral("\U0001F600 fetch") << 3 << 5 << 3 << 5;
    QTest::newRow("of three bytes") << QStringLiteral("a \u20ac b") << 3 << 3 << 2 << 1;
    QTest::newRow("no length marks one") << QStringLiteral("(C") << 1 << 0 << 0 << 1;
    QTest::newRow("over the end of the line") << QStringLiteral("(C ab") << 4 << 50 << 3 << 2;
    QTest::newRow("after the last character") << QStringLiteral("(C") << 9 << 1 << 1 << 1;
    QTest::newRow("empty line") << QString() << 1 << 1 << 0 << 0;
}

void tst_PlanText::spotsBecomeRanges() {
    QFETCH(QString, line);
    QFETCH(int, column);
    QFETCH(int, bytes);
    QFETCH(int, start);
    QFETCH(int, length);
    const posh::Spot spot{1, static_cast<std::uint32_t>(column), 0, static_cast<std::uint32_t>(bytes)};
    QCOMPARE(rangeOf(spot, line), (TextRange{start, length}));
}

void tst_PlanText::columnsCountCodePoints() {
    QCOMPARE(columnOf(QStringLiteral("abc"), 2), 3);
    QCOMPARE(columnOf(QStringLiteral("\U0001F600b"), 2), 2);
    QCOMPARE(columnOf(QStringLiteral("ab"), 99), 3);
    QCOMPARE(columnOf(QString(), 0), 1);
}

void tst_PlanText::placesLeadToParts_data() {
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("name");
    QTest::newRow("on a name") << 5 << 10 << QStringLiteral("grab");
    QTest::newRow("in a trigger") << 5 << 32 << QStringLiteral("Distance");
    QTest::newRow("on an act") << 5 << 60 << QStringLiteral("CloseGripper");
    QTest::newRow("between lines: what began last") << 12 << 1 << QStringLiteral("Delivered");
    QTest::newRow("before everything") << 1 << 1 << QString();
    QTest::newRow("after everything") << 99 << 1 << QStringLiteral("rest");
}

void tst_PlanText::placesLeadToParts() {
    QFETCH(int, line);
    QFETCH(int, column);
    QFETCH(QString, name);
    const PlanTree tree(planOf(courier_plan));
    const PlanNodeId node = nodeAtPlace(tree, line, column);
    QCOMPARE(node.valid() ? tree[node].name : QString(), name);
}

void tst_PlanText::findingsAreMarkedWhereTheyStand() {
    PlanTextEdit edit;
    const auto reading = posh::readPlan(faulty);
    QVERIFY(reading.findings.size() >= 2);
    edit.setPlanText(faulty, reading.findings);
    QStringList marked;
    for (const auto& mark : edit.extraSelections())
        marked << QString::number(mark.cursor.blockNumber() + 1) + u' ' + mark.cursor.selectedText();
    QVERIFY2(marked.contains(QStringLiteral("2 a")), qPrintable(marked.join('\n')));
    QVERIFY2(marked.contains(QStringLiteral("4 XX")), qPrintable(marked.join('\n')));
    QVERIFY(edit.toolTipAt(2).contains(QStringLiteral("E301")));
    QVERIFY(edit.toolTipAt(1).isEmpty());
}

void tst_PlanText::notesAreMarkedBesideTheirLine() {
    const std::string text = "(\n (RDC d (drives ((e a)))))\n";
    const auto noted = [](const QImage& image, int width) {
        int pixels = 0;
        for (int x = 0; x < width; ++x)
            for (int y = 0; y < image.height(); ++y)
                pixels += image.pixelColor(x, y) == tokens().accent ? 1 : 0;
        return pixels > 0;
    };
    PlanTextEdit edit;
    edit.resize(400, 300);
    edit.setPlanText(text, {});
    QVERIFY(!noted(edit.grab().toImage(), edit.gutterWidth()));
    edit.setPlanText(text, {}, notesOf(posh::readPlan(text).plan));
    QVERIFY2(noted(edit.grab().toImage(), edit.gutterWidth()), "the circle beside the line");
    QVERIFY(edit.toolTipAt(1).isEmpty());
    QVERIFY2(edit.toolTipAt(2).startsWith(QStringLiteral("2:2: note N501: ")), qPrintable(edit.toolTipAt(2)));
    QVERIFY(edit.wordsAtCursor().isEmpty());
    QTest::keyClick(&edit, Qt::Key_F8);
    QCOMPARE(edit.wordsAtCursor(), edit.toolTipAt(2));
    edit.setFindings({});
    QVERIFY(edit.toolTipAt(2).isEmpty());
    QVERIFY(notesOf(posh::readPlan("((DC d (drives ((e a)))))").plan).empty());
}

void tst_PlanText::spotsBehindTheTextAreMarkedAtItsEnd() {
    PlanTextEdit edit;
    for (const char* text : {"", "(", "((C a\n", "((C a\n\n\n"}) {
        edit.setPlanText(text, posh::readPlan(text).findings);
        QVERIFY(!edit.extraSelections().isEmpty());
        edit.nextFinding();
    }
    edit.showPlace(posh::Spot{999, 999, 0, 5});
}

void tst_PlanText::f8GoesOverTheFindings() {
    PlanTextEdit edit;
    edit.nextFinding(); // without any
    edit.setPlanText(faulty, posh::readPlan(faulty).findings);
    std::set<int> lines;
    for (std::size_t i = 0; i < edit.findings().size(); ++i) {
        QTest::keyClick(&edit, Qt::Key_F8);
        lines.insert(edit.textCursor().blockNumber() + 1);
        QVERIFY(edit.findingAtCursor());
    }
    QVERIFY(lines.contains(2) && lines.contains(4));
    const int last = edit.textCursor().position();
    QTest::keyClick(&edit, Qt::Key_F8);
    QTest::keyClick(&edit, Qt::Key_F8, Qt::ShiftModifier);
    QCOMPARE(edit.textCursor().position(), last);
}

void tst_PlanText::showingAPlaceIsSilent() {
    PlanTextEdit edit;
    QSignalSpy entered(&edit, &PlanTextEdit::placeEntered);
    edit.setPlanText(courier_plan, {});
    edit.showPlace({5, 8, 0, 4});
    QCOMPARE(edit.textCursor().blockNumber(), 4);
    QCOMPARE(entered.count(), 0);
    QCOMPARE(edit.extraSelections().size(), 1);
    edit.showPlace({});
    QCOMPARE(edit.extraSelections().size(), 0);
}

void tst_PlanText::linesAreSeenFromTheirBeginning() {
    PlanTextEdit edit;
    edit.resize(60, 100); // too narrow for anything
    edit.show();
    edit.setPlanText(courier_plan, {});
    edit.showPlace({5, 10, 0, 4});
    edit.resize(400, 300);
    QTRY_COMPARE(edit.horizontalScrollBar()->value(), 0);
}

void tst_PlanText::theLineOfTheCursorStaysInViewWhenRoomIsTaken() {
    PlanTextEdit edit;
    edit.resize(300, 300);
    edit.setPlanText(std::string(99, '\n'), {});
    edit.show();
    QVERIFY(QTest::qWaitForWindowExposed(&edit));
    const auto seen = [&edit] {
        return edit.cursorRect().top() >= 0 && edit.cursorRect().bottom() <= edit.viewport()->height();
    };
    while (edit.cursorRect().bottom() + edit.cursorRect().height() < edit.viewport()->height())
        edit.moveCursor(QTextCursor::Down);
    QVERIFY(seen());
    edit.resize(300, 200);
    QVERIFY(seen());
    edit.verticalScrollBar()->setValue(60); // the person looks elsewhere
    edit.resize(300, 150);
    QCOMPARE(edit.verticalScrollBar()->value(), 60);
}

void tst_PlanText::cursorTellsItsPlace() {
    PlanTextEdit edit;
    edit.setPlanText(courier_plan, {});
    QSignalSpy entered(&edit, &PlanTextEdit::placeEntered);
    QTextCursor cursor(edit.document()->findBlockByNumber(4));
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, 9);
    edit.setTextCursor(cursor);
    QCOMPARE(entered.count(), 1);
    QCOMPARE(entered[0][0].toInt(), 5);
    QCOMPARE(entered[0][1].toInt(), 10);
}

void tst_PlanText::runningLinesAreTinted() {
    PlanTextEdit edit;
    edit.setPlanText(courier_plan, {});
    edit.setRunningLines({3, 14, 500});
    QCOMPARE(edit.extraSelections().size(), 2);
    QCOMPARE(edit.extraSelections()[1].cursor.blockNumber(), 13);
    edit.setPlanText(courier_plan, {});
    QVERIFY(edit.extraSelections().isEmpty());
}

void tst_PlanText::itCannotBeEdited() {
    PlanTextEdit edit;
    edit.setPlanText("(a)", {});
    QTest::keyClicks(&edit, QStringLiteral("x"));
    QTest::keyClick(&edit, Qt::Key_Delete);
    QCOMPARE(edit.toPlainText(), QStringLiteral("(a)"));
}

void tst_PlanText::bothThemesPaint() {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(theme);
        PlanTextEdit edit;
        edit.resize(400, 300);
        edit.setPlanText(faulty, posh::readPlan(faulty).findings);
        edit.setRunningLines({1});
        const QImage image = edit.grab().toImage();
        bool danger = false;
        for (int x = 0; x < edit.gutterWidth(); ++x)
            for (int y = 0; y < image.height(); ++y)
                danger = danger || image.pixelColor(x, y) == tokens().danger;
        QVERIFY2(danger, "the cross beside the line of an error");
    }
}

USAR_TEST(tst_PlanText)

} // namespace tst_plan_text

#include "tst_plan_text.moc"
