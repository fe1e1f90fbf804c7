#include <QAbstractItemModelTester>
#include <QListView>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/panels/robot_list.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_robot_list {

using namespace usar;
using namespace usar::widgets;

namespace {

RobotRow robot(int id, int number, const char* state = "idle") {
    return {{id}, number, QStringLiteral("R%1").arg(number), QStringLiteral("AirRobot"), QString::fromLatin1(state),
            71.4, false};
}

} // namespace

class tst_RobotList : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void rowsAreInTheOrderOfNumbers();
    void modelIsSoundThroughAllChanges();
    void unchangedRobotTellsNobody();
    void rowIsASentenceForAssistiveTools();
    void clickSelects();
    void selectingByTheWindowIsSilent();
    void severalAreChosenWithTheSelectedOne();
    void selectionSurvivesUpdates();
    void removingTheSelectedRobotSelectsANeighbor();
    void deleteAsksForRemovalAndRemovesNothing();
    void emptyListSaysHowToSpawn();
    void rowHasTheRobotsColorAndGreysWhenStale();
    void wholeHeightShowsEveryRobot();
    void rowsGetFewerLinesWhereRoomIsShort_data();
    void rowsGetFewerLinesWhereRoomIsShort();

private:
    QListView* view() const { return list_->findChild<QListView*>(); }
    QPoint center(int row) const { return view()->visualRect(list_->model().index(row)).center(); }

    std::unique_ptr<RobotList> list_;
};

void tst_RobotList::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_RobotList::init() {
    list_ = std::make_unique<RobotList>();
    list_->resize(260, 300);
    list_->show();
    QVERIFY(QTest::qWaitForWindowExposed(list_.get()));
}

void tst_RobotList::cleanup() {
    list_.reset();
}

void tst_RobotList::rowsAreInTheOrderOfNumbers() {
    list_->updateRobot(robot(10, 3));
    list_->updateRobot(robot(11, 1));
    list_->updateRobot(robot(12, 2));
    for (int i = 0; i < 3; ++i)
        QCOMPARE(list_->model().row(i).number, i + 1);
    list_->updateRobot(robot(11, 5));
    QCOMPARE(list_->model().row(2).id.value, 11);
}

void tst_RobotList::modelIsSoundThroughAllChanges() {
    RobotListModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (const int id : {2, 1, 3})
        model.updateRobot(robot(id, id));
    model.updateRobot(robot(1, 1, "scanning"));
    model.updateRobot(robot(1, 4));
    model.removeRobot({2});
    model.removeRobot({99});
    model.updateRobot(robot(1, 4, "landed"));
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(model.row(1).state, QStringLiteral("landed"));
    model.removeRobot({3});
    model.removeRobot({1});
    QCOMPARE(model.rowCount(), 0);
}

void tst_RobotList::unchangedRobotTellsNobody() {
    RobotListModel model;
    model.updateRobot(robot(1, 1));
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.updateRobot(robot(1, 1));
    QCOMPARE(changed.count(), 0);
    model.updateRobot(robot(1, 1, "scanning"));
    QCOMPARE(changed.count(), 1);
}

void tst_RobotList::rowIsASentenceForAssistiveTools() {
    RobotListModel model;
    RobotRow row = robot(1, 1, "scanning");
    row.stale = true;
    model.updateRobot(row);
    QCOMPARE(model.index(0).data().toString(), QStringLiteral("R1, AirRobot, scanning, battery 71 %, no news"));
    QVERIFY(model.index(0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("Key 1")));
}

void tst_RobotList::clickSelects() {
    list_->updateRobot(robot(7, 1));
    list_->updateRobot(robot(8, 2));
    QSignalSpy selected(list_.get(), &RobotList::robotSelected);
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, center(1));
    QCOMPARE(selected.count(), 1);
    QCOMPARE(selected[0][0].value<RobotId>().value, 8);
    QTest::keyClick(view(), Qt::Key_Up);
    QCOMPARE(selected.last()[0].value<RobotId>().value, 7);
}

void tst_RobotList::selectingByTheWindowIsSilent() {
    list_->updateRobot(robot(7, 1));
    list_->updateRobot(robot(8, 2));
    QSignalSpy selected(list_.get(), &RobotList::robotSelected);
    list_->selectRobot({8});
    QCOMPARE(list_->selectedRobot(), std::optional(RobotId{8}));
    list_->selectRobot({99});
    QCOMPARE(list_->selectedRobot(), std::optional<RobotId>());
    QCOMPARE(selected.count(), 0);
}

void tst_RobotList::severalAreChosenWithTheSelectedOne() {
    using Ids = std::vector<RobotId>;
    for (int number = 1; number <= 4; ++number)
        list_->updateRobot(robot(number, number));
    list_->selectRobot({1});
    QCOMPARE(list_->chosenRobots(), Ids{{1}});
    QSignalSpy changed(list_.get(), &RobotList::chosenChanged);
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, Qt::ControlModifier, center(2));
    QCOMPARE(list_->selectedRobot(), std::optional(RobotId{3}));
    list_->selectRobot({3}); // As the window does in answer to robotSelected.
    QCOMPARE(list_->chosenRobots(), (Ids{{1}, {3}}));
    QVERIFY(changed.count() > 0);
    list_->updateRobot(robot(2, 2, "scanning"));
    QCOMPARE(list_->chosenRobots(), (Ids{{1}, {3}}));
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, Qt::ControlModifier, center(2));
    QVERIFY2(view()->selectionModel()->isSelected(list_->model().index(2)), "what the window shows stays marked");
    QTest::keyClick(view(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(list_->chosenRobots().size(), std::size_t(4));
    list_->removeRobot({3});
    QCOMPARE(list_->chosenRobots(), (Ids{{1}, {2}, {4}}));
    list_->selectRobot({4});
    list_->selectRobot({2});
    QCOMPARE(list_->chosenRobots(), Ids{{2}});
}

void tst_RobotList::selectionSurvivesUpdates() {
    list_->updateRobot(robot(7, 1));
    list_->updateRobot(robot(8, 2));
    list_->selectRobot({8});
    QSignalSpy selected(list_.get(), &RobotList::robotSelected);
    list_->updateRobot(robot(8, 2, "scanning"));
    QCOMPARE(list_->selectedRobot(), std::optional(RobotId{8}));
    list_->updateRobot(robot(8, 4));
    QCOMPARE(list_->selectedRobot(), std::optional(RobotId{8}));
    list_->updateRobot(robot(6, 1));
    list_->removeRobot({7});
    QCOMPARE(list_->selectedRobot(), std::optional(RobotId{8}));
    QCOMPARE(selected.count(), 0);
}

void tst_RobotList::removingTheSelectedRobotSelectsANeighbor() {
    list_->updateRobot(robot(7, 1));
    list_->updateRobot(robot(8, 2));
    list_->selectRobot({8});
    QSignalSpy selected(list_.get(), &RobotList::robotSelected);
    list_->removeRobot({8});
    QCOMPARE(list_->selectedRobot(), std::optional(RobotId{7}));
    QCOMPARE(selected.count(), 1);
    QCOMPARE(selected[0][0].value<RobotId>().value, 7);
}

void tst_RobotList::deleteAsksForRemovalAndRemovesNothing() {
    list_->updateRobot(robot(7, 1));
    QSignalSpy asked(list_.get(), &RobotList::removeRequested);
    list_->activateWindow();
    view()->setFocus();
    QTRY_VERIFY(view()->hasFocus());
    list_->selectRobot({7});
    QTest::keyClick(view(), Qt::Key_Delete);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked[0][0].value<RobotId>().value, 7);
    QCOMPARE(list_->model().rowCount(), 1);
}

void tst_RobotList::emptyListSaysHowToSpawn() {
    QVERIFY(list_->findChild<EmptyState*>()->isVisible());
    list_->updateRobot(robot(1, 1));
    QVERIFY(!list_->findChild<EmptyState*>()->isVisible());
    list_->removeRobot({1});
    QVERIFY(list_->findChild<EmptyState*>()->isVisible());
}

void tst_RobotList::rowHasTheRobotsColorAndGreysWhenStale() {
    list_->updateRobot(robot(1, 1));
    const auto ink = [&] {
        const QRect row = view()->visualRect(list_->model().index(0)); // lays the list out
        const QImage image = list_->grab(row).toImage();
        int colored = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                colored += image.pixel(x, y) == robotColor(1).rgb() ? 1 : 0;
        return colored;
    };
    const int fresh = ink();
    QVERIFY2(fresh > 200, qPrintable(QString::number(fresh)));
    RobotRow old = robot(1, 1);
    old.stale = true;
    list_->updateRobot(old);
    QVERIFY(ink() < fresh / 2);
}

void tst_RobotList::wholeHeightShowsEveryRobot() {
    QSignalSpy changed(list_.get(), &RobotList::wholeHeightChanged);
    for (int number = 1; number <= 9; ++number)
        list_->updateRobot(robot(number, number));
    QCOMPARE(changed.count(), 9);
    list_->updateRobot(robot(3, 3, "flying"));
    QCOMPARE(changed.count(), 9);
    list_->resize(260, list_->wholeHeight_px());
    QTRY_COMPARE(view()->verticalScrollBar()->maximum(), 0);
    list_->resize(260, list_->wholeHeight_px(1) - 1);
    QTRY_VERIFY(view()->verticalScrollBar()->maximum() > 0);
    list_->removeRobot({9});
    QCOMPARE(changed.count(), 10);
}

void tst_RobotList::rowsGetFewerLinesWhereRoomIsShort_data() {
    QTest::addColumn<int>("lines");
    for (const int lines : {1, 2, 3})
        QTest::addRow("%d", lines) << lines;
}

void tst_RobotList::rowsGetFewerLinesWhereRoomIsShort() {
    QFETCH(int, lines);
    for (int number = 1; number <= 9; ++number)
        list_->updateRobot(robot(number, number, "flying to lane 3 of 5"));
    list_->resize(260, list_->wholeHeight_px(lines));
    QTRY_COMPARE(view()->visualRect(list_->model().index(8)).bottom() + 1, 9 * view()->sizeHintForRow(0));
    QCOMPARE(9 * view()->sizeHintForRow(0), list_->wholeHeight_px(lines));
    QCOMPARE(view()->verticalScrollBar()->maximum(), 0);
    QCOMPARE(list_->heightWithin_px(list_->height() + 5), list_->height());
    for (int number = 9; number > 2; --number)
        list_->removeRobot({number});
    QTRY_VERIFY(2 * view()->sizeHintForRow(0) >= list_->wholeHeight_px(3)); // There is room again.
}

USAR_TEST(tst_RobotList)

} // namespace tst_robot_list

#include "tst_robot_list.moc"
