#include <algorithm>
#include <vector>

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "core/protocol/reader.h"
#include "widgets/empty_state.h"
#include "widgets/message_list.h"
#include "widgets/theme.h"

using namespace usar;
using namespace usar::widgets;

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
    void onlyThisTypeFilters();
    void emptyListSaysWhy();
    void rowsAreAllEquallyHigh();
    void insertingIntoAFullListIsSmooth();

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
    list_->takeCommand({protocol::GetStartPoses{}, {"session", {1}}}, Seconds(2));
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
    list_->setPaused(true);
    feed(5);
    const auto* count = list_->findChild<QLabel*>(QStringLiteral("count"));
    QTRY_VERIFY(count->text().contains(QStringLiteral("5 waiting")));
    QCOMPARE(list_->model().rowCount(), 1);
    list_->setPaused(false);
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
    list_->setPaused(true);
    const int capacity = static_cast<int>(list_->model().capacity());
    feed(capacity + 5);
    list_->setPaused(false);
    QTRY_COMPARE(list_->model().rowCount(), capacity);
    QCOMPARE(list_->model().index(0, MessageModel::Text).data().toString(), QStringLiteral("6 lines not shown"));
}

void tst_MessageList::searchAndWayFilter() {
    feed(3);
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2));
    list_->takeCommand({protocol::GetStartPoses{}, {}}, Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 5);
    QTest::keyClicks(list_->findChild<QLineEdit*>(), QStringLiteral("sonar"));
    QCOMPARE(list_->model().rowCount(), 3);
    list_->setFilter({QString(), Direction::Out});
    QCOMPARE(list_->model().rowCount(), 1);
    list_->findChild<QComboBox*>()->setCurrentIndex(0);
    QCOMPARE(list_->model().rowCount(), 5);
}

void tst_MessageList::copyTakesWholeLines() {
    feed(2);
    QTRY_COMPARE(list_->model().rowCount(), 2);
    list_->view()->selectRow(1);
    list_->view()->actions().at(0)->trigger();
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("2\t1.00\t")));
    list_->view()->actions().at(1)->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("SEN {Time 1} {Type Sonar} {Name F1 Range 2.5}"));
}

void tst_MessageList::onlyThisTypeFilters() {
    feed(2);
    list_->takeLine(reader_.read("STA {Time 2}"), Seconds(2));
    QTRY_COMPARE(list_->model().rowCount(), 3);
    list_->view()->selectRow(0);
    list_->view()->actions().at(2)->trigger();
    QCOMPARE(list_->model().rowCount(), 2);
    QCOMPARE(list_->model().filter().words, QStringLiteral("SEN Sonar"));
}

void tst_MessageList::emptyListSaysWhy() {
    QVERIFY(list_->emptyState()->isVisible());
    QCOMPARE(list_->emptyState()->accessibleName(), QStringLiteral("No messages yet"));
    feed(1);
    QTRY_VERIFY(!list_->emptyState()->isVisible());
    list_->setFilter({QStringLiteral("zzz"), {}});
    QVERIFY(list_->emptyState()->isVisible());
    QCOMPARE(list_->emptyState()->accessibleName(), QStringLiteral("No line fits"));
    list_->setFilter({});
    list_->clear();
    QCOMPARE(list_->emptyState()->accessibleName(), QStringLiteral("No messages yet"));
}

void tst_MessageList::rowsAreAllEquallyHigh() {
    feed(10);
    list_->takeLine(reader_.read("SEN {Type RangeScanner} {Name S} {Range 1,2,3}"), Seconds(1));
    QTRY_COMPARE(list_->model().rowCount(), 11);
    for (int i = 0; i < 11; ++i)
        QCOMPARE(list_->view()->rowHeight(i), list_->view()->rowHeight(0));
}

void tst_MessageList::insertingIntoAFullListIsSmooth() {
    feed(static_cast<int>(MessageModel::default_capacity));
    QTRY_COMPARE(list_->model().rowCount(), static_cast<int>(MessageModel::default_capacity));
    std::vector<double> times_ms;
    for (int i = 0; i < 20; ++i) {
        feed(330);
        QSignalSpy inserted(&list_->model(), &QAbstractItemModel::rowsInserted);
        QElapsedTimer timer;
        timer.start();
        QMetaObject::invokeMethod(list_->findChild<QTimer*>(), "timeout");
        list_->view()->viewport()->repaint();
        times_ms.push_back(static_cast<double>(timer.nsecsElapsed()) * 1e-6);
        QCOMPARE(inserted.count(), 1);
    }
    std::ranges::sort(times_ms);
    qInfo("330 lines into a full list, painted: %.1f ms (median)", times_ms[10]);
    QVERIFY(times_ms.front() < 50.0);
}

QTEST_MAIN(tst_MessageList)
#include "tst_message_list.moc"
