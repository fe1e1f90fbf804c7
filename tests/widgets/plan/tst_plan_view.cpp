#include <algorithm>
#include <cmath>
#include <functional>

#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_reasons.h"
#include "widgets/plan/plan_painter.h"
#include "widgets/plan/plan_view.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_plan_view {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string root = "/P:0/DC:0";
const std::string fetch = "/P:0/DC:0/DE:1/A:0/C:0";

PlanSnapshot running(std::vector<std::string> paths, Seconds now = Seconds(10.0)) {
    PlanSnapshot snapshot;
    snapshot.now = now;
    snapshot.activities.resize(paths.size());
    for (PlanActivity& activity : snapshot.activities) {
        activity.running = true;
        activity.last_active = now;
        activity.started = 1;
    }
    snapshot.paths = std::make_shared<const std::vector<std::string>>(std::move(paths));
    return snapshot;
}

void drag(QWidget& view, QPoint from, QPoint to) {
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&view, from + (to - from) / 2);
    QTest::mouseMove(&view, to);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
}

void wheel(QWidget& view, QPointF at, int delta) {
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
}

} // namespace

class tst_PlanView : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void withoutPlanItSaysWhatWillAppear();
    void keysWithoutPlanDoNoHarm();
    void wheelZoomsAtTheCursor();
    void dragPansAndClickDoesNot();
    void arrowKeysPan_data();
    void arrowKeysPan();
    void nobodyGetsLost();
    void fitShowsAll();
    void clickSelectsCardsAndSenses();
    void clickOnTheMarkFoldsAndTheCardStays();
    void spaceFoldsAndUnfolds();
    void returnFollowsALinkAndAsksForTheText();
    void everyPartIsReachedByKeys();
    void foldedSelectionMovesToWhatIsSeen();
    void searchGoesRoundAndOpensTheWay();
    void newsIsTakenAtMostOncePerTick();
    void hiddenViewTakesNoNews();
    void runningPartsAreWalkedByKey();
    void showRunningFoldsTheRest();
    void whatRunsIsBrighter_data();
    void whatRunsIsBrighter();
    void verdictsDifferInShape();
    void smallScaleShowsBlocksWithNames();
    void selectionAndFoldsOutliveAnEdit();
    void otherSharingKeepsSelectionAndNews();
    void newsOfAnotherPlanIsSaid();
    void narrowViewIsAnOutline();
    void textsAreForScreenReadersToo();
    void drawingIsPaintedWholeForPaper();

private:
    QPoint middle(const std::string& path) const;
    PlanNodeId node(const std::string& path) const { return view_->tree().find(path); }
    std::unique_ptr<PlanView> view_;
    std::unique_ptr<QSignalSpy> taken_; ///< one entry for each snapshot that was taken
};

void tst_PlanView::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_PlanView::init() {
    view_ = std::make_unique<PlanView>();
    taken_ = std::make_unique<QSignalSpy>(view_.get(), &PlanView::refreshed);
    view_->resize(1000, 700);
    view_->setPlan(planOf(courier_plan));
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void tst_PlanView::cleanup() {
    taken_.reset();
    view_.reset();
}

/// Of the title of a card, or of a sense's row.
QPoint tst_PlanView::middle(const std::string& path) const {
    const QRectF box = view_->layout().box(view_->tree(), node(path));
    return view_->toScreen({box.center().x(), box.top() + 10.0}).toPoint();
}

void tst_PlanView::withoutPlanItSaysWhatWillAppear() {
    QVERIFY(view_->emptyState()->isHidden());
    view_->clear();
    QVERIFY(view_->emptyState()->isVisible());
    QVERIFY(!view_->emptyState()->accessibleName().isEmpty());
    view_->grab();
    view_->setPlan(planOf(courier_plan));
    QVERIFY(view_->emptyState()->isHidden());
}

void tst_PlanView::keysWithoutPlanDoNoHarm() {
    view_->clear();
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Home, Qt::Key_End, Qt::Key_N, Qt::Key_F,
                              Qt::Key_Left, Qt::Key_Plus, Qt::Key_Escape})
        for (const Qt::KeyboardModifier modifier : {Qt::NoModifier, Qt::ControlModifier, Qt::ShiftModifier})
            QTest::keyClick(view_.get(), key, modifier);
    wheel(*view_, {50, 50}, 120);
    drag(*view_, {100, 100}, {200, 150});
    view_->fit();
    view_->showRunning();
    view_->foldAll();
    view_->unfoldAll();
    QCOMPARE(view_->find(QStringLiteral("a")), 0);
    QCOMPARE(view_->selected(), PlanNodeId{});
}

void tst_PlanView::wheelZoomsAtTheCursor() {
    const QPointF cursor(600, 150);
    const QPointF there = view_->toLayout(cursor);
    const double scale = view_->scale();
    wheel(*view_, cursor, 240);
    QVERIFY(view_->scale() > 1.4 * scale);
    QVERIFY((view_->toLayout(cursor) - there).manhattanLength() < 1e-6);
    wheel(*view_, cursor, -240);
    QVERIFY(qAbs(view_->scale() - scale) < 1e-9);
}

void tst_PlanView::dragPansAndClickDoesNot() {
    const QPointF before = view_->toScreen({0, 0});
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, QPoint(990, 690));
    QCOMPARE(view_->toScreen({0, 0}), before);
    drag(*view_, {500, 300}, {460, 320});
    QVERIFY((view_->toScreen({0, 0}) - before - QPointF(-40, 20)).manhattanLength() < 1e-6);
    QCOMPARE(view_->selected(), PlanNodeId{});
}

void tst_PlanView::arrowKeysPan_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<QPointF>("drawing_goes");
    QTest::newRow("left shows what is left") << Qt::Key_Left << QPointF(64, 0);
    QTest::newRow("right") << Qt::Key_Right << QPointF(-64, 0);
    QTest::newRow("up") << Qt::Key_Up << QPointF(0, 64);
    QTest::newRow("down") << Qt::Key_Down << QPointF(0, -64);
}

void tst_PlanView::arrowKeysPan() {
    QFETCH(Qt::Key, key);
    QFETCH(QPointF, drawing_goes);
    const QPointF before = view_->toScreen({0, 0});
    QTest::keyClick(view_.get(), key);
    QVERIFY((view_->toScreen({0, 0}) - before - drawing_goes).manhattanLength() < 1e-6);
}

void tst_PlanView::nobodyGetsLost() {
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Down, Qt::Key_Right, Qt::Key_Up}) {
        for (int i = 0; i < 100; ++i)
            QTest::keyClick(view_.get(), key, Qt::ShiftModifier);
        const QRectF seen(view_->toLayout({0, 0}), view_->toLayout({1000, 700}));
        QVERIFY(seen.intersects(view_->layout().bounds()));
    }
}

void tst_PlanView::fitShowsAll() {
    wheel(*view_, {10, 10}, 1200);
    QTest::keyClick(view_.get(), Qt::Key_F);
    const auto shows_all = [&] {
        const QRectF seen(view_->toLayout({0, 0}), view_->toLayout({double(view_->width()), double(view_->height())}));
        return seen.contains(view_->layout().bounds());
    };
    QVERIFY(shows_all());
    view_->resize(700, 500);
    QVERIFY2(shows_all(), "what was fitted stays so");
}

void tst_PlanView::clickSelectsCardsAndSenses() {
    QSignalSpy selected(view_.get(), &PlanView::selectionChanged);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, middle(root + "/DE:1"));
    QCOMPARE(view_->selected(), node(root + "/DE:1"));
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, middle(root + "/DE:1/S:1"));
    QCOMPARE(view_->selected(), node(root + "/DE:1/S:1"));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QCOMPARE(view_->selected(), PlanNodeId{});
    QCOMPARE(selected.count(), 3);
}

void tst_PlanView::clickOnTheMarkFoldsAndTheCardStays() {
    const PlanNodeId work = node(root + "/DE:1");
    const QPointF before = view_->toScreen(view_->layout().box(view_->tree(), work).topLeft());
    const QRectF box = view_->layout().box(view_->tree(), work);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, view_->toScreen(box.topRight() + QPointF(-14, 12)).toPoint());
    QVERIFY(view_->folds().folded(view_->tree(), work));
    QVERIFY(!view_->layout().shown({work.value + 3}));
    QVERIFY((view_->toScreen(view_->layout().box(view_->tree(), work).topLeft()) - before).manhattanLength() < 1e-6);
    QCOMPARE(view_->selected(), PlanNodeId{});
}

void tst_PlanView::spaceFoldsAndUnfolds() {
    view_->selectPath(root + "/DE:1");
    QTest::keyClick(view_.get(), Qt::Key_Space);
    QVERIFY(view_->folds().folded(view_->tree(), view_->selected()));
    QTest::keyClick(view_.get(), Qt::Key_Space);
    QVERIFY(!view_->folds().folded(view_->tree(), view_->selected()));
}

void tst_PlanView::returnFollowsALinkAndAsksForTheText() {
    QSignalSpy activated(view_.get(), &PlanView::activated);
    const std::string link = fetch + "/CE:1/A:0/AP:0/A:2/AP:1";
    view_->selectPath(link);
    QTest::keyClick(view_.get(), Qt::Key_Return);
    QCOMPARE(view_->selected(), node(root + "/DE:0/A:0/AP:1"));
    QCOMPARE(activated.count(), 0);
    QTest::keyClick(view_.get(), Qt::Key_Return);
    QCOMPARE(activated.count(), 1);
    view_->selectPath(link);
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, middle(link));
    QCOMPARE(view_->selected(), node(root + "/DE:0/A:0/AP:1"));
}

void tst_PlanView::everyPartIsReachedByKeys() {
    std::vector<bool> reached(static_cast<std::size_t>(view_->tree().size()), false);
    QTest::keyClick(view_.get(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(view_->selected(), PlanNodeId{0});
    // Depth first: into each part, over its senses and siblings, and back out.
    const std::function<void()> visit = [&] {
        for (;;) {
            const PlanNodeId here = view_->selected();
            reached[here.index()] = true;
            const QRectF box = view_->layout().box(view_->tree(), here);
            QVERIFY(QRectF(view_->rect()).contains(view_->toScreen(box.center())));
            if (!view_->tree().children(here).empty()) {
                QTest::keyClick(view_.get(), Qt::Key_Right, Qt::ControlModifier);
                visit();
                while (view_->selected() > here)
                    QTest::keyClick(view_.get(), Qt::Key_Left, Qt::ControlModifier);
                QCOMPARE(view_->selected(), here);
            }
            QTest::keyClick(view_.get(), Qt::Key_Down, Qt::ControlModifier);
            if (view_->selected() == here)
                return;
        }
    };
    visit();
    QVERIFY(std::all_of(reached.begin(), reached.end(), [](bool was) { return was; }));
    QTest::keyClick(view_.get(), Qt::Key_End);
    QCOMPARE(view_->selected(), PlanNodeId{view_->tree().size() - 1});
    for (int i = 0; i < 50; ++i)
        QTest::keyClick(view_.get(), i % 2 ? Qt::Key_Up : Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(view_->selected(), PlanNodeId{0});
}

void tst_PlanView::foldedSelectionMovesToWhatIsSeen() {
    view_->selectPath(fetch + "/CE:0/A:0");
    view_->setFolded(node(root + "/DE:1"), true);
    QCOMPARE(view_->selected(), node(root + "/DE:1"));
    view_->foldAll();
    QVERIFY(!view_->selected().valid() || view_->layout().shown(view_->selected()));
}

void tst_PlanView::searchGoesRoundAndOpensTheWay() {
    view_->foldAll();
    QCOMPARE(view_->find(QStringLiteral("distance")), 3);
    const PlanNodeId first = node(fetch + "/CE:0/S:0");
    QCOMPARE(view_->selected(), first);
    QVERIFY(!view_->layout().box(view_->tree(), first).isNull());
    view_->findNext();
    view_->findNext();
    QCOMPARE(view_->tree()[view_->selected()].detail, QStringLiteral("< 1.0"));
    view_->findNext();
    QCOMPARE(view_->selected(), first);
    view_->findNext(true);
    QCOMPARE(view_->tree()[view_->selected()].detail, QStringLiteral("< 1.0"));
    QCOMPARE(view_->find(QStringLiteral("zebra")), 0);
    view_->findNext();
}

void tst_PlanView::newsIsTakenAtMostOncePerTick() {
    for (int i = 0; i < 100; ++i)
        view_->setSnapshot(running({root}, Seconds(double(i))));
    QCOMPARE(taken_->count(), 0);
    QTRY_COMPARE(taken_->count(), 1);
    QCOMPARE(view_->states().now().count(), 99.0);
}

void tst_PlanView::hiddenViewTakesNoNews() {
    view_->hide();
    QSignalSpy refreshed(view_.get(), &PlanView::refreshed);
    view_->setSnapshot(running({root}));
    const test::Beats frames(16);
    QVERIFY(test::holdsUntil([&] { return refreshed.isEmpty(); }, [&] { return frames.count() >= 3; }));
    QVERIFY(!view_->states()[PlanNodeId{0}].running);
    view_->show();
    QTRY_VERIFY(view_->states()[PlanNodeId{0}].running);
}

void tst_PlanView::runningPartsAreWalkedByKey() {
    view_->setSnapshot(running({root, root + "/DE:1", fetch}));
    QTRY_COMPARE(taken_->count(), 1);
    for (const std::string& path : {root, root + "/DE:1", fetch, root}) {
        QTest::keyClick(view_.get(), Qt::Key_N);
        QCOMPARE(view_->selected(), node(path));
    }
    QTest::keyClick(view_.get(), Qt::Key_N, Qt::ShiftModifier);
    QCOMPARE(view_->selected(), node(fetch));
}

void tst_PlanView::showRunningFoldsTheRest() {
    view_->setSnapshot(running({root, root + "/DE:1", fetch}));
    QTRY_COMPARE(taken_->count(), 1);
    view_->showRunning();
    QVERIFY(view_->layout().shown(node(fetch)));
    QVERIFY(!view_->layout().shown(node(fetch + "/CE:0")));
    QVERIFY(!view_->layout().shown(node(root + "/DE:0/A:0")));
}

void tst_PlanView::whatRunsIsBrighter_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("dark theme") << true;
    QTest::newRow("light theme") << false;
}

void tst_PlanView::whatRunsIsBrighter() {
    QFETCH(bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    const auto fill = [&](const std::string& path) {
        const QRectF box = view_->layout().box(view_->tree(), node(path));
        return view_->grab().toImage().pixelColor(view_->toScreen(box.bottomLeft() + QPointF(12, -3)).toPoint());
    };
    const QColor before = fill(fetch);
    view_->setSnapshot(running({fetch}));
    QTRY_COMPARE(taken_->count(), 1);
    const QColor now = fill(fetch);
    QVERIFY(contrast(before, now) > 1.25);
    PlanSnapshot later = running({fetch});
    later.activities[0].running = false;
    later.now = Seconds(12.0);
    view_->setSnapshot(later);
    QTRY_COMPARE(taken_->count(), 2);
    const QColor fading = fill(fetch);
    QVERIFY(contrast(before, fading) > 1.08 && contrast(before, fading) < contrast(before, now));
    applyTheme(Theme::Dark);
}

void tst_PlanView::verdictsDifferInShape() {
    const auto mark = [&](std::optional<bool> holds) {
        PlanSnapshot snapshot = running({root + "/DE:0/S:0"});
        snapshot.activities[0] = {};
        if (holds)
            snapshot.activities[0].answer = SenseAnswer{QStringLiteral("1"), *holds, Seconds(0), snapshot.now};
        const auto taken = taken_->count();
        view_->setSnapshot(snapshot);
        [&] { QTRY_COMPARE(taken_->count(), taken + 1); }();
        const QRectF row = view_->layout().box(view_->tree(), node(root + "/DE:0/S:0"));
        const QRectF place(view_->toScreen(row.topLeft() + QPointF(plan_card::padding_px, 0.0)),
                           view_->toScreen(row.bottomLeft() + QPointF(plan_card::padding_px + 14.0, 0.0)));
        const QImage image = view_->grab(place.toRect()).toImage().convertToFormat(QImage::Format_Grayscale8);
        double sum = 0.0; // of what is not ground
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                sum += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(0, 0)));
        return sum / (image.width() * image.height());
    };
    const double unknown = mark(std::nullopt);
    const double no = mark(false);
    const double yes = mark(true);
    QVERIFY2(yes > 1.8 * no && no > 1.8 * unknown,
             qPrintable(QStringLiteral("%1 %2 %3").arg(unknown).arg(no).arg(yes)));
}

void tst_PlanView::smallScaleShowsBlocksWithNames() {
    QCOMPARE(planDetailAt(1.0), PlanDetail::Full);
    while (planDetailAt(view_->scale()) == PlanDetail::Full)
        view_->zoomOut();
    QCOMPARE(planDetailAt(view_->scale()), PlanDetail::Names);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, middle(root + "/DE:1/S:1"));
    QCOMPARE(view_->selected(), node(root + "/DE:1")); // the rows are not drawn
    view_->grab();
    while (planDetailAt(view_->scale()) == PlanDetail::Names)
        view_->zoomOut();
    QCOMPARE(planDetailAt(view_->scale()), PlanDetail::Blocks);
    view_->grab();
}

void tst_PlanView::selectionAndFoldsOutliveAnEdit() {
    view_->selectPath(fetch + "/CE:3");
    view_->setFolded(node(root + "/DE:0"), true);
    std::string text(courier_plan);
    text.replace(text.find("((grab"), 0, "((look Look))\n      ");
    view_->setPlan(planOf(text));
    QCOMPARE(view_->tree()[view_->selected()].name, QStringLiteral("go"));
    QVERIFY(view_->folds().folded(view_->tree(), node(root + "/DE:0")));
    text.replace(text.find("((go"), 4, "((gone");
    view_->setPlan(planOf(text));
    QVERIFY(!view_->selected().valid() || view_->tree().contains(view_->selected()));
}

void tst_PlanView::otherSharingKeepsSelectionAndNews() {
    const std::string brake = fetch + "/CE:1/A:0/AP:0/A:2/AP:1/A:1";
    view_->setSharing(PlanSharing::Expanded);
    view_->setSnapshot(running({brake}));
    QTRY_COMPARE(taken_->count(), 1);
    view_->selectPath(brake);
    view_->setSharing(PlanSharing::Once);
    QCOMPARE(view_->selected(), node(root + "/DE:0/A:0/AP:1/A:1"));
    QVERIFY(view_->states()[view_->selected()].running);
}

void tst_PlanView::newsOfAnotherPlanIsSaid() {
    view_->setSnapshot(running({root, fetch}));
    QTRY_COMPARE(taken_->count(), 1);
    QVERIFY(planReservation(view_->tree(), view_->states()).isEmpty());
    const QImage before = view_->grab().toImage();
    view_->setSnapshot(running({root, fetch, root + "/DE:9"}));
    QTRY_COMPARE(taken_->count(), 2);
    QVERIFY(planReservation(view_->tree(), view_->states()).contains(QStringLiteral("not in this plan")));
    QVERIFY(view_->grab().toImage() != before);
}

void tst_PlanView::narrowViewIsAnOutline() {
    QCOMPARE(view_->layout().flow(), PlanFlow::Across);
    view_->resize(320, 700);
    QCOMPARE(view_->layout().flow(), PlanFlow::Down);
    view_->setFlow(PlanFlow::Across);
    QCOMPARE(view_->layout().flow(), PlanFlow::Across);
}

void tst_PlanView::textsAreForScreenReadersToo() {
    QVERIFY(!view_->accessibleName().isEmpty());
    QVERIFY(view_->accessibleDescription().contains(QStringLiteral("Ctrl")));
    view_->selectPath(fetch + "/CE:0");
    const QString text = view_->accessibleDescription();
    for (const char* part :
         {"element grab", "at most 3 starts", "Priority 1", "only when near", "has not run yet", "Line 5"})
        QVERIFY2(text.contains(QLatin1String(part)), qPrintable(text));
    view_->selectPath(fetch + "/CE:1");
    QVERIFY(view_->accessibleDescription().contains(QStringLiteral("Priority 2, shared with others")));
    view_->setFolded(view_->selected(), true);
    QVERIFY(view_->accessibleDescription().contains(QStringLiteral("Folded parts")));
}

void tst_PlanView::drawingIsPaintedWholeForPaper() {
    QImage image(view_->drawingSize().toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    view_->paintDrawing(painter);
    painter.end();
    const PlanNodeId last{view_->tree().size() - 1};
    const QPointF at = view_->layout().box(view_->tree(), last).topLeft() + QPointF(16.0, 17.0);
    QVERIFY(image.pixelColor(at.toPoint()) != QColor(Qt::white));
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
}

USAR_TEST(tst_PlanView)

} // namespace tst_plan_view

#include "tst_plan_view.moc"
