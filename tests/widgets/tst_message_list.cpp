#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"
#include "widgets/messages/message_list.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_message_list {

using namespace usar;
using namespace usar::widgets;

namespace {

double usedByThread_ms() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) * 1e3 + static_cast<double>(used.tv_nsec) * 1e-6;
}

} // namespace

class tst_MessageList : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void showsLinesInAndOut();
    void manyLinesAreOneInsertion();
    void staysAtTheEndUntilScrolledUp();
    void contentStandsStillWhileTheRingTurns();
    void pauseKeepsLinesForLater();
    void hiddenListKeepsLinesForLater();
    void linesLeftOutAreCounted();
    void linesThatWaitedTooLongAreCounted();
    void searchAndWayFilter();
    void copyTakesWholeLines();
    void tooMuchForTheClipboardIsRefused();
    void shownLinesAreSaved_data();
    void shownLinesAreSaved();
    void aFileThatCannotBeSavedIsNamed();
    void onlyCommandsAreSentAgain();
    void aCommandLeadsToItsCauseAndBack();
    void detailsShowFaultsUnderACaret();
    void linesOfAnotherRobotAreKeptApart();
    void aLineIsFoundByItsNumberEvenWhileItWaits();
    void typesSeenAreOfferedAndTicked();
    void aWrongExpressionIsSaidAndFiltersNothing();
    void followingEndsWhereThePersonScrolls();
    void aHundredThousandLinesNeverHoldTheWindow_data();
    void aHundredThousandLinesNeverHoldTheWindow();
    void onlyThisTypeFilters();
    void emptyListSaysWhy();
    void rowsAreAllEquallyHigh();
    void aFullListTakesABatchAtOnce();

private:
    void feed(int count);

    std::unique_ptr<MessageList> list_;
    protocol::Reader reader_;
};

void tst_MessageList::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_MessageList::init() {
    list_ = std::make_unique<MessageList>();
    list_->resize(700, 300);
    list_->show();
    QVERIFY(QTest::qWaitForWindowExposed(list_.get()));
    reader_ = {};
}

void tst_MessageList::cleanup() {
    list_.reset();
}

void tst_MessageList::feed(int count) {
    for (int i = 0; i < count; ++i)
        list_->takeLine(reader_.read("SEN {Time 1} {Type Sonar} {Name F1 Range 2.5}"), Seconds(1));
}

void tst_MessageList::showsLinesInAndOut() {
    feed(1);
    list_->takeCommand("GETSTARTPOSES", {by::Other{"session"}, {1}}, Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 2);
    QVERIFY(list_->model().index(0, MessageModel::Way).data().toString().contains(QStringLiteral("in")));
    QVERIFY(list_->model().index(1, MessageModel::Way).data().toString().contains(QStringLiteral("out")));
    QCOMPARE(list_->model().index(1, MessageModel::Text).data().toString(), QStringLiteral("GETSTARTPOSES"));
    QCOMPARE(list_->model().index(0, MessageModel::Number).data().toString(), QStringLiteral("1"));
}

void tst_MessageList::manyLinesAreOneInsertion() {
    QSignalSpy inserted(&list_->model(), &QAbstractItemModel::rowsInserted);
    feed(500);
    QCOMPARE(inserted.count(), 0);
    QTRY_COMPARE(list_->model().rowCount(), 500);
    QCOMPARE(inserted.count(), 1);
}

void tst_MessageList::staysAtTheEndUntilScrolledUp() {
    feed(100);
    QTRY_COMPARE(list_->model().rowCount(), 100);
    QScrollBar* bar = list_->view()->verticalScrollBar();
    QCOMPARE(bar->value(), bar->maximum());
    bar->setValue(10);
    feed(100);
    QTRY_COMPARE(list_->model().rowCount(), 200);
    QCOMPARE(bar->value(), 10);
}

void tst_MessageList::contentStandsStillWhileTheRingTurns() {
    feed(static_cast<int>(MessageModel::default_capacity));
    QTRY_COMPARE(list_->model().rowCount(), static_cast<int>(MessageModel::default_capacity));
    QScrollBar* bar = list_->view()->verticalScrollBar();
    bar->setValue(5000);
    const std::uint64_t seen = list_->model().row(list_->view()->rowAt(0)).number;
    feed(200);
    QTRY_COMPARE(list_->model().row(0).number, std::uint64_t{201});
    QCOMPARE(list_->model().row(list_->view()->rowAt(0)).number, seen);
}

void tst_MessageList::pauseKeepsLinesForLater() {
    feed(1);
    QTRY_COMPARE(list_->model().rowCount(), 1);
    list_->actions().pause->setChecked(true);
    feed(5);
    QString count;
    connect(list_.get(), &MessageList::countChanged, this, [&](const QString& text) { count = text; });
    QTRY_COMPARE(count, QStringLiteral("1 lines, 5 waiting"));
    QCOMPARE(list_->model().rowCount(), 1);
    list_->actions().pause->setChecked(false);
    QTRY_COMPARE(list_->model().rowCount(), 6);
}

void tst_MessageList::hiddenListKeepsLinesForLater() {
    list_->hide();
    feed(7);
    QCOMPARE(list_->model().rowCount(), 0);
    list_->show();
    QTRY_COMPARE(list_->model().rowCount(), 7);
}

void tst_MessageList::linesLeftOutAreCounted() {
    list_->setFilter({QStringLiteral("no such word"), Direction::Out});
    feed(1);
    list_->takeNotShown(0);
    list_->takeNotShown(1000);
    list_->takeNotShown(234);
    QTRY_COMPARE(list_->model().rowCount(), 1);
    QCOMPARE(list_->model().index(0, MessageModel::Text).data().toString(), QStringLiteral("1,234 lines not shown"));
    QCOMPARE(list_->model().index(0, MessageModel::Number).data().toString(), QString());
}

void tst_MessageList::linesThatWaitedTooLongAreCounted() {
    list_->actions().pause->setChecked(true);
    const int capacity = static_cast<int>(list_->model().capacity());
    feed(capacity + 5);
    list_->actions().pause->setChecked(false);
    QTRY_COMPARE(list_->model().rowCount(), capacity);
    QCOMPARE(list_->model().index(0, MessageModel::Text).data().toString(), QStringLiteral("6 lines not shown"));
}

void tst_MessageList::searchAndWayFilter() {
    feed(3);
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2));
    list_->takeCommand("GETSTARTPOSES", {}, Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 5);
    QTest::keyClicks(list_->findChild<QLineEdit*>(), QStringLiteral("sonar"));
    QCOMPARE(list_->model().rowCount(), 3);
    list_->setFilter({QString(), Direction::Out});
    QCOMPARE(list_->model().rowCount(), 1);
    list_->findChild<QComboBox*>()->setCurrentIndex(0);
    QCOMPARE(list_->model().rowCount(), 5);
}

void tst_MessageList::copyTakesWholeLines() {
    list_->nameConnection({0}, QStringLiteral("R1"));
    feed(2);
    QTRY_COMPARE(list_->model().rowCount(), 2);
    list_->view()->selectRow(1);
    list_->actions().copy->trigger();
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("2\t1.00\tR1\tin\tSEN Sonar\t")));
    list_->actions().copy_text->trigger();
    const QString text = QStringLiteral("SEN {Time 1} {Type Sonar} {Name F1 Range 2.5}");
    QCOMPARE(QGuiApplication::clipboard()->text(), text);
    list_->actions().copy_json->trigger();
    const QJsonObject object = QJsonDocument::fromJson(QGuiApplication::clipboard()->text().toUtf8()).object();
    QCOMPARE(object["line"].toString(), text);
    QCOMPARE(object["direction"].toString(), QStringLiteral("in"));
    QCOMPARE(object["fields"].toArray().at(0).toObject()["value"].toDouble(), 2.5);
    list_->actions().copy_shown->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(), text + u'\n' + text);
}

void tst_MessageList::tooMuchForTheClipboardIsRefused() {
    QSignalSpy failed(list_.get(), &MessageList::failed);
    QGuiApplication::clipboard()->setText(QStringLiteral("before"));
    for (int i = 0; i < 20; ++i)
        list_->takeLine(reader_.read("SEN " + std::string(1'000'000, 'x')), Seconds(1));
    QTRY_COMPARE(list_->model().rowCount(), 20);
    list_->actions().copy_shown->trigger();
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed.at(0).at(0).toString().contains(QStringLiteral("Save them to a file")));
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("before"));
}

void tst_MessageList::shownLinesAreSaved_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("first");
    QTest::newRow("as text") << "lines.txt" << QByteArray("1\t1.00\tR1\tin\tSEN Sonar\tSEN {Time 1}");
    QTest::newRow("as JSON lines") << "lines.jsonl" << QByteArray("{\"diagnostics\":[],\"direction\":\"in\"");
}

void tst_MessageList::shownLinesAreSaved() {
    QFETCH(QString, name);
    QFETCH(QByteArray, first);
    const QTemporaryDir folder;
    list_->nameConnection({0}, QStringLiteral("R1"));
    feed(300);
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 301);
    list_->setFilter({QStringLiteral("sonar")});
    QSignalSpy saved(list_.get(), &MessageList::saved);
    list_->saveShown(folder.filePath(name));
    feed(1); // comes when the file is whole
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(saved.at(0).at(1).toInt(), 300);
    QFile file(folder.filePath(name));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 300);
    QVERIFY2(lines.front().startsWith(first), lines.front());
    QTRY_COMPARE(list_->model().rowCount(), 301);
}

void tst_MessageList::aFileThatCannotBeSavedIsNamed() {
    QSignalSpy failed(list_.get(), &MessageList::failed);
    list_->saveShown(QStringLiteral("/no such folder/lines.txt"));
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed.at(0).at(0).toString().contains(QStringLiteral("/no such folder/lines.txt")));
}

void tst_MessageList::onlyCommandsAreSentAgain() {
    feed(1);
    list_->takeCommand("DRIVE {Left 1}", {by::Other{"test"}, {1}}, Seconds(1), {0});
    list_->takeCommand("STEP", {by::Other{"test"}, {1}}, Seconds(1), {0});
    QTRY_COMPARE(list_->model().rowCount(), 3);
    QSignalSpy resent(list_.get(), &MessageList::resendRequested);
    list_->view()->selectRow(0);
    QVERIFY(!list_->actions().resend->isEnabled());
    list_->view()->selectAll();
    QVERIFY(list_->actions().resend->isEnabled());
    list_->actions().resend->trigger();
    QCOMPARE(resent.count(), 1);
    QCOMPARE(resent.at(0).at(1).toStringList(), QStringList({"DRIVE {Left 1}", "STEP"}));
}

void tst_MessageList::aCommandLeadsToItsCauseAndBack() {
    list_->takeLine(reader_.read("STA {Time 1}"), Seconds(1), {7});
    list_->takeLine(reader_.read("SEN {Type INS}"), Seconds(1), {7});
    list_->takeCommand("DRIVE {Left 1}", {by::Behavior{"test", "rising"}, {1}}, Seconds(1), {7});
    list_->selectConnection({7});
    QTRY_COMPARE(list_->model().rowCount(), 3);
    list_->actions().details->setChecked(true);
    list_->setFilter({.direction = Direction::Out});
    list_->view()->selectRow(0);
    QVERIFY(list_->detail()->toPlainText().contains(QStringLiteral("Sent by test: rising, on line 1 (STA).")));
    QVERIFY(list_->actions().cause->isEnabled());
    list_->actions().cause->trigger(); // hidden by the filter, which goes
    QCOMPARE(list_->view()->currentIndex().row(), 0);
    QVERIFY(list_->detail()->toPlainText().contains(QStringLiteral("It made us send DRIVE (No. 1).")));
    emit list_->detail()->anchorClicked(QUrl(QStringLiteral("row:2")));
    QCOMPARE(list_->view()->currentIndex().row(), 2);
}

void tst_MessageList::detailsShowFaultsUnderACaret() {
    list_->actions().details->setChecked(true);
    list_->takeLine(reader_.read("SEN {Time 1.5} {Type Sonar} {Name F1 Range 2.5"), Seconds(1));
    QTRY_COMPARE(list_->model().rowCount(), 1);
    list_->view()->selectRow(0);
    const QString text = list_->detail()->toPlainText();
    QVERIFY2(text.contains(QStringLiteral("Column ")), qPrintable(text));
    QVERIFY2(text.contains(u'^'), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("2.5 m")), qPrintable(text));
}

void tst_MessageList::linesOfAnotherRobotAreKeptApart() {
    list_->nameConnection({1}, QStringLiteral("R1"));
    list_->nameConnection({2}, QStringLiteral("R2"));
    list_->selectConnection({1});
    list_->takeLine(reader_.read("STA {Time 1}"), Seconds(1), {1});
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2), {2});
    list_->takeNotShown(5, {2});
    QTRY_COMPARE(list_->model().rowCount(), 1);
    QCOMPARE(list_->model().totalOf({1}), 1);
    QCOMPARE(list_->model().totalOf({2}), 2);
    QVERIFY(list_->view()->isColumnHidden(MessageModel::Robot));
    list_->actions().all_robots->setChecked(true);
    QCOMPARE(list_->model().rowCount(), 3);
    QVERIFY(!list_->view()->isColumnHidden(MessageModel::Robot));
    QCOMPARE(list_->model().index(1, MessageModel::Robot).data().toString(), QStringLiteral("R2"));
    list_->actions().all_robots->setChecked(false);
    list_->selectConnection({2});
    QCOMPARE(list_->model().rowCount(), 2);
}

void tst_MessageList::aLineIsFoundByItsNumberEvenWhileItWaits() {
    list_->selectConnection({1});
    list_->actions().pause->setChecked(true);
    for (int i = 1; i <= 3; ++i)
        list_->takeLine(reader_.read("STA {Time 1}"), Seconds(10.0 * i), {2});
    QCOMPARE(list_->model().total(), 0);
    QCOMPARE(list_->timeOf({2}, {2}), std::optional(Seconds(20)));
    QVERIFY(!list_->timeOf({1}, {2}) && !list_->timeOf({2}, {4}) && !list_->timeOf({2}, {}));
    QVERIFY(!list_->jumpToLine({2}, {4}));
    QVERIFY(list_->jumpToLine({2}, {2}));
    QCOMPARE(list_->model().row(list_->view()->currentIndex().row()).number, std::uint64_t(2));
    QCOMPARE(list_->timeOf({2}, {2}), std::optional(Seconds(20)));
    list_->clear();
    QVERIFY(!list_->timeOf({2}, {2}) && !list_->jumpToLine({2}, {2}));
}

void tst_MessageList::typesSeenAreOfferedAndTicked() {
    feed(3);
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 4);
    TypeChoiceButton* button = list_->bar()->types();
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(button->list()->isVisible());
    QCOMPARE(button->list()->count(), 2);
    QCOMPARE(button->list()->item(0)->text(), QStringLiteral("SEN Sonar  (3)"));
    button->list()->item(0)->setCheckState(Qt::Unchecked);
    QCOMPARE(list_->model().rowCount(), 1);
    QCOMPARE(button->text(), QStringLiteral("All but 1 ▾"));
    button->list()->window()->close();
}

void tst_MessageList::aWrongExpressionIsSaidAndFiltersNothing() {
    feed(2);
    QTRY_COMPARE(list_->model().rowCount(), 2);
    auto* search = list_->findChild<QLineEdit*>(QStringLiteral("search"));
    QTest::keyClicks(search, QStringLiteral("/f1 range [0-9/"));
    QCOMPARE(list_->model().rowCount(), 2);
    QVERIFY2(search->toolTip().startsWith(QStringLiteral("Invalid regular expression at column ")),
             qPrintable(search->toolTip()));
    search->clear();
    QTest::keyClicks(search, QStringLiteral("/f1 range 3/"));
    QCOMPARE(list_->model().rowCount(), 0);
    QVERIFY(!search->toolTip().startsWith(QStringLiteral("Not ")));
}

void tst_MessageList::followingEndsWhereThePersonScrolls() {
    feed(100);
    QTRY_COMPARE(list_->model().rowCount(), 100);
    QVERIFY(list_->actions().follow->isChecked());
    list_->view()->verticalScrollBar()->setValue(10);
    QVERIFY(!list_->actions().follow->isChecked());
    list_->actions().follow->trigger();
    QCOMPARE(list_->view()->verticalScrollBar()->value(), list_->view()->verticalScrollBar()->maximum());
    QTest::mouseClick(list_->view()->viewport(), Qt::LeftButton, {}, QPoint(20, 20)); // to read that line
    QVERIFY(!list_->actions().follow->isChecked());
    const int before = list_->view()->verticalScrollBar()->value();
    feed(100);
    QTRY_COMPARE(list_->model().rowCount(), 200);
    QCOMPARE(list_->view()->verticalScrollBar()->value(), before);
}

/// The longest that any step held the event loop up, without the time in which other programs had the processor.
void tst_MessageList::aHundredThousandLinesNeverHoldTheWindow_data() {
    QTest::addColumn<QString>("words");
    QTest::newRow("words") << "range";
    QTest::newRow("nothing fits") << "no such words";
    QTest::newRow("regular expression") << "/f1 .*2\\.5/";
}

void tst_MessageList::aHundredThousandLinesNeverHoldTheWindow() {
    QFETCH(QString, words);
    const int capacity = static_cast<int>(MessageModel::default_capacity);
    feed(capacity);
    QTRY_COMPARE(list_->model().rowCount(), capacity);
    double last_ms = usedByThread_ms();
    double longest_ms = 0.0;
    QTimer pulse;
    connect(&pulse, &QTimer::timeout, this, [&] {
        const double now_ms = usedByThread_ms();
        longest_ms = std::max(longest_ms, now_ms - std::exchange(last_ms, now_ms));
    });
    pulse.start(0);
    list_->setFilter({words});
    const test::Beats frames(33);
    for (int i = 0; i < 10; ++i) {
        feed(330);
        QTRY_VERIFY(frames.count() > i);
    }
    QTRY_VERIFY(!list_->model().filtering());
    qInfo("'%s' over %d lines with 10,000 a second coming: longest block %.0f ms", qPrintable(words), capacity,
          longest_ms);
    QVERIFY2(longest_ms < 100, qPrintable(QString::number(longest_ms)));
    QCOMPARE(list_->model().rowCount() > 0, words != QStringLiteral("no such words"));
}

void tst_MessageList::onlyThisTypeFilters() {
    feed(2);
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 3);
    list_->view()->selectRow(0);
    list_->actions().only_type->trigger();
    QCOMPARE(list_->model().rowCount(), 2);
    QVERIFY(list_->model().filter().types == (TypeChoice{{"SEN Sonar"}, true}));
    list_->actions().no_filter->trigger();
    QCOMPARE(list_->model().rowCount(), 3);
    list_->view()->selectRow(0);
    list_->actions().hide_type->trigger();
    QCOMPARE(list_->model().rowCount(), 1);
}

void tst_MessageList::emptyListSaysWhy() {
    QVERIFY(list_->findChild<EmptyState*>()->isVisible());
    QCOMPARE(list_->findChild<EmptyState*>()->accessibleName(), QStringLiteral("No messages yet"));
    feed(1);
    QTRY_VERIFY(!list_->findChild<EmptyState*>()->isVisible());
    list_->setFilter({QStringLiteral("zzz"), {}});
    QVERIFY(list_->findChild<EmptyState*>()->isVisible());
    QCOMPARE(list_->findChild<EmptyState*>()->accessibleName(), QStringLiteral("No matches"));
    list_->setFilter({});
    list_->clear();
    QCOMPARE(list_->findChild<EmptyState*>()->accessibleName(), QStringLiteral("No messages yet"));
}

void tst_MessageList::rowsAreAllEquallyHigh() {
    feed(10);
    list_->takeLine(reader_.read("SEN {Type RangeScanner} {Name S} {Range 1,2,3}"), Seconds(1));
    QTRY_COMPARE(list_->model().rowCount(), 11);
    for (int i = 0; i < 11; ++i)
        QCOMPARE(list_->view()->rowHeight(i), list_->view()->rowHeight(0));
}

void tst_MessageList::aFullListTakesABatchAtOnce() {
    feed(static_cast<int>(MessageModel::default_capacity));
    QTRY_COMPARE(list_->model().rowCount(), static_cast<int>(MessageModel::default_capacity));
    for (int i = 0; i < 20; ++i) {
        feed(330);
        QSignalSpy inserted(&list_->model(), &QAbstractItemModel::rowsInserted);
        QMetaObject::invokeMethod(list_->findChild<QTimer*>(), "timeout");
        QCOMPARE(inserted.count(), 1);
    }
    QCOMPARE(list_->model().rowCount(), static_cast<int>(MessageModel::default_capacity));
}

USAR_TEST(tst_MessageList)

} // namespace tst_message_list

#include "tst_message_list.moc"
