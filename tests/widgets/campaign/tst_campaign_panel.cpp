// The dock for campaigns: its form, what it says of the progress, and its lists.
#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/campaign/campaign_panel.h"

namespace tst_campaign_panel {

using namespace usar::widgets;

namespace {

const std::vector<CampaignBehavior> behaviors{{"a/cpp", "Survey (C++)"}, {"a/posh", "Survey (POSH)"}};

template <class Widget>
Widget* namedPart(QWidget& parent, const QString& name) {
    for (Widget* const one : parent.findChildren<Widget*>())
        if (one->accessibleName() == name)
            return one;
    return nullptr;
}

void fill(CampaignPanel& panel, int runs) {
    panel.table().begin({{"Duration", "s", 1}});
    std::vector<CampaignRun> rows;
    for (int i = 0; i < runs; ++i)
        rows.push_back({.number = i,
                        .pair = i / 2,
                        .variant = i % 2 ? "POSH" : "C++",
                        .seed = static_cast<quint64>(1 + i / 2),
                        .outcome = i == 2 ? "failed" : "done",
                        .done = i != 2,
                        .reason = "So.",
                        .figures = {90.0 + i}});
    panel.table().append(rows);
}

} // namespace

class tst_CampaignPanel : public QObject {
    Q_OBJECT
private slots:
    void init() {
        panel_ = std::make_unique<CampaignPanel>();
        panel_->resize(panel_->sizeHint());
        panel_->show();
    }

    void theFormSaysWhatWasChosen() {
        CampaignForm& form = *panel_->form();
        form.setMission("AirRobot in a town", {});
        form.setBehaviors(behaviors, "a/cpp");
        form.setParameters({{"h_m", "Height", "m", "6"}});
        form.setFolder("/results");
        QCOMPARE(form.wish().behaviors, QStringList{"a/cpp"});
        QCOMPARE(form.wish().folder, QString("/results"));
        QCOMPARE(form.wish().parameter, QString());
        auto* const parameter = namedPart<QComboBox>(form, "Parameter that is varied");
        auto* const values = namedPart<QLineEdit>(form, "Values of the parameter");
        QVERIFY(!values->isVisible());
        QTest::keyClick(parameter, Qt::Key_Down);
        QVERIFY(values->isVisible());
        QTest::keyClicks(values, "3, 4");
        QCOMPARE(form.wish().parameter, QString("h_m"));
        QCOMPARE(form.wish().values, QString("3, 4"));
        auto* const faults = namedPart<QComboBox>(form, "Faults");
        form.setFaultCount(2);
        QCOMPARE(faults->itemText(1), QString("those in the dock Faults (2)"));
        QTest::keyClick(faults, Qt::Key_End);
        QVERIFY(form.wish().faults == CampaignFaults::Swarm);
        QVERIFY(namedPart<QAbstractSpinBox>(form, "Share of the swarm")->isVisible());
    }

    void checkedBehaviorsStayWhileTheyAreThere() {
        CampaignForm& form = *panel_->form();
        form.setBehaviors(behaviors, "a/posh");
        QCOMPARE(form.wish().behaviors, QStringList{"a/posh"});
        form.setBehaviors({behaviors[1], behaviors[0]}, "a/cpp");
        QCOMPARE(form.wish().behaviors, QStringList{"a/posh"});
        form.setBehaviors({{"b/x", "X"}}, "b/x"); // Another robot has other behaviors.
        QCOMPARE(form.wish().behaviors, QStringList{"b/x"});
    }

    void aFileTakesThePlaceOfTheFields() {
        CampaignForm& form = *panel_->form();
        form.setMission("AirRobot in a town", "There is no area.");
        QVERIFY(namedPart<QLabel>(form, "What is wrong with the campaign")->isVisible());
        QSignalSpy wanted(&form, &CampaignForm::ownCampaignWanted);
        form.setFile("Town, from town.json");
        QVERIFY(!namedPart<QSpinBox>(form, "First seed")->isVisible());
        QVERIFY(!namedPart<QLabel>(form, "What is wrong with the campaign")->isVisible());
        QVERIFY(namedPart<QSpinBox>(form, "Missions at a time")->isVisible());
        for (QPushButton* const button : form.findChildren<QPushButton*>())
            if (button->text() == "Set up one here")
                QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(wanted.size(), 1);
    }

    void theHeadOffersWhatCanBeDone_data() {
        QTest::addColumn<int>("state");
        QTest::addColumn<bool>("can_resume");
        QTest::addColumn<QString>("button");
        QTest::newRow("closed") << int(CampaignState::Closed) << true << "";
        QTest::newRow("running") << int(CampaignState::Running) << true << "Stop";
        QTest::newRow("stopping") << int(CampaignState::Stopping) << true << "Stop";
        QTest::newRow("stopped") << int(CampaignState::Stopped) << true << "Resume";
        QTest::newRow("stopped, its file unknown") << int(CampaignState::Stopped) << false << "";
        QTest::newRow("complete") << int(CampaignState::Complete) << true << "";
    }

    void theHeadOffersWhatCanBeDone() {
        QFETCH(int, state);
        QFETCH(bool, can_resume);
        panel_->setProgress(
            {.state = static_cast<CampaignState>(state), .title = "Town", .runs = 4, .can_resume = can_resume});
        QStringList shown;
        for (const QPushButton* const button : panel_->findChildren<QPushButton*>())
            if (button->isVisible() && (button->text() == "Stop" || button->text() == "Resume"))
                shown << button->text();
        QTEST(shown.join(' '), "button");
    }

    void aRowIsChosenByMouseAndByKey() {
        fill(*panel_, 4);
        panel_->showPage(CampaignPanel::Runs);
        QTableView& view = *panel_->runs()->view();
        QSignalSpy chosen(panel_->runs(), &RunsView::runChosen);
        const QPoint at = view.visualRect(view.model()->index(2, 1)).center();
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(panel_->runs()->currentRun(), std::optional(2));
        QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(chosen.size(), 1);
        panel_->activateWindow();
        view.setFocus();
        QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
        QTest::keyClick(&view, Qt::Key_Up);
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(chosen.size(), 2);
        QCOMPARE(chosen.back().front().toInt(), 1);
    }

    void twoRowsCanBeSelectedToBeCompared() {
        fill(*panel_, 4);
        panel_->showPage(CampaignPanel::Runs);
        RunsView& runs = *panel_->runs();
        QSignalSpy changed(&runs, &RunsView::currentChanged);
        runs.view()->selectRow(3);
        QCOMPARE(runs.selectedRuns(), std::vector<int>{3});
        runs.view()->selectionModel()->select(runs.view()->model()->index(1, 0),
                                              QItemSelectionModel::Select | QItemSelectionModel::Rows);
        QCOMPARE(runs.selectedRuns(), (std::vector<int>{1, 3}));
        QVERIFY(changed.size() >= 2);
    }

    void theMenuOfARowOffersAllOtherVariants() {
        fill(*panel_, 4);
        panel_->showPage(CampaignPanel::Runs);
        RunsView& runs = *panel_->runs();
        runs.view()->selectRow(0);
        QSignalSpy chosen(&runs, &RunsView::partnerChosen);
        const auto offers = [&] {
            QStringList words;
            const std::unique_ptr<QMenu> menu(runs.makeRowMenu());
            for (const QMenu* const inner : menu->findChildren<QMenu*>())
                for (QAction* const action : inner->actions()) {
                    words << action->text();
                    if (action->text() == "Fine")
                        action->trigger();
                }
            return words;
        };
        runs.setPartners({{1, "POSH"}});
        QCOMPARE(offers(), QStringList()); // The command itself compares with the only one.
        runs.setPartners({{1, "POSH"}, {2, "Fine"}});
        QCOMPARE(offers(), (QStringList{"POSH", "Fine"}));
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen.front().front().toInt(), 2);
    }

    void onlyWhatIsNotDoneCanBeListed() {
        fill(*panel_, 4);
        panel_->showPage(CampaignPanel::Runs);
        QTest::mouseClick(panel_->runs()->findChild<QCheckBox*>(), Qt::LeftButton, {}, QPoint(8, 12));
        QCOMPARE(panel_->runs()->view()->model()->rowCount(), 1);
        QTest::mouseClick(panel_->runs()->findChild<QCheckBox*>(), Qt::LeftButton, {}, QPoint(8, 12));
        QCOMPARE(panel_->runs()->view()->model()->rowCount(), 4);
        QTest::keyClicks(namedPart<QLineEdit>(*panel_->runs(), "Filter runs"), "POSH");
        QCOMPARE(panel_->runs()->view()->model()->rowCount(), 2);
    }

    void aFilterThatFindsNothingSaysSo() {
        RunsView& runs = *panel_->runs();
        panel_->showPage(CampaignPanel::Runs);
        QAction open("Open sample campaign");
        runs.emptyState()->setAction(&open);
        const auto* const button = runs.emptyState()->findChild<QPushButton*>();
        QVERIFY(button->isVisible()); // There is no run yet.
        fill(*panel_, 4);
        QVERIFY(!runs.emptyState()->isVisible());
        QTest::keyClicks(namedPart<QLineEdit>(runs, "Filter runs"), "lisp");
        QVERIFY(runs.emptyState()->isVisible());
        QCOMPARE(runs.emptyState()->accessibleName(), QString("No run has all of these words"));
        QVERIFY(!button->isVisible());
        namedPart<QLineEdit>(runs, "Filter runs")->clear();
        QVERIFY(!runs.emptyState()->isVisible());
        panel_->table().begin({});
        QCOMPARE(runs.emptyState()->accessibleName(), QString("No runs yet"));
        QVERIFY(button->isVisible());
        runs.emptyState()->setAction(nullptr);
    }

    void aLongerVariantWidensItsColumn() {
        panel_->showPage(CampaignPanel::Runs);
        fill(*panel_, 2);
        const int before_px = panel_->runs()->view()->columnWidth(RunTable::Variant);
        panel_->table().append({{.number = 9, .variant = "C++, Scan altitude 12.5", .figures = {1.0}}});
        const int after_px = panel_->runs()->view()->columnWidth(RunTable::Variant);
        QVERIFY(after_px > before_px);
        QVERIFY(after_px > panel_->runs()->view()->fontMetrics().horizontalAdvance("C++, Scan altitude 12.5"));
        panel_->table().append({{.number = 10, .variant = QString(200, 'w'), .figures = {1.0}}});
        QVERIFY(panel_->runs()->view()->columnWidth(RunTable::Variant) <= 320);
    }

    void theHistogramFollowsTheTableWhileItIsSeen() {
        panel_->showPage(CampaignPanel::Histograms);
        fill(*panel_, 4);
        QTRY_COMPARE(panel_->histograms()->histogram().variants.size(), std::size_t(2));
        panel_->showPage(CampaignPanel::Runs);
        HistogramView seen(panel_->table());
        seen.show();
        fill(*panel_, 1);
        QTRY_COMPARE(seen.histogram().variants.size(), std::size_t(1)); // The other one would have been drawn first.
        QCOMPARE(panel_->histograms()->histogram().variants.size(), std::size_t(2)); // A hidden view does no work.
        panel_->showPage(CampaignPanel::Histograms);
        QCOMPARE(panel_->histograms()->histogram().variants.size(), std::size_t(1));
    }

    void causesStayOpenAndTheirRunsAreChosen() {
        CauseList& list = *panel_->causes();
        panel_->showPage(CampaignPanel::Why);
        const CausedRun run{4, "Run 4", "It fell at 3 s."};
        list.setCauses({{"failed: It fell at # s.", "C++ 1", {run}}}, true);
        list.tree()->topLevelItem(0)->setExpanded(true);
        list.setCauses({{"crashed: Signal #", "C++ 2", {run, run}}, {"failed: It fell at # s.", "C++ 1", {run}}}, true);
        QVERIFY(!list.tree()->topLevelItem(0)->isExpanded());
        QVERIFY(list.tree()->topLevelItem(1)->isExpanded());
        QSignalSpy chosen(&list, &CauseList::runChosen);
        emit list.tree()->itemActivated(list.tree()->topLevelItem(1), 0);
        emit list.tree()->itemActivated(list.tree()->topLevelItem(1)->child(0), 0); // It counts the variants.
        QCOMPARE(chosen.size(), 0);
        emit list.tree()->itemActivated(list.tree()->topLevelItem(1)->child(1), 0);
        QCOMPARE(chosen.front().front().toInt(), 4);
    }

    void runsOfACauseStandBelowTheirPlaces() {
        CauseList& list = *panel_->causes();
        const QString here = "around x 5 m, y 5 m";
        list.setCauses(
            {{"It fell.", "3 \u00d7 C++", {{1, "Run 1", "So.", here}, {2, "Run 2", "So.", here}, {3, "Run 3", "So."}}}},
            true);
        const QTreeWidgetItem* const cause = list.tree()->topLevelItem(0);
        QCOMPARE(cause->childCount(), 3); // The first counts the variants.
        QCOMPARE(cause->child(1)->text(0), here);
        QCOMPARE(cause->child(1)->text(1), QString("2"));
        QCOMPARE(cause->child(1)->childCount(), 2);
        QCOMPARE(cause->child(2)->text(0), QString("at a place that is not known"));
        QSignalSpy chosen(&list, &CauseList::runChosen);
        emit list.tree()->itemActivated(cause->child(1), 0);
        QCOMPARE(chosen.size(), 0);
        emit list.tree()->itemActivated(cause->child(1)->child(1), 0);
        QCOMPARE(chosen.front().front().toInt(), 2);
    }

    void theVerdictIsReadAsText() {
        VerdictView& view = *panel_->verdict();
        QVERIFY(view.text().trimmed().isEmpty());
        view.setVerdicts(
            {{"B is better than <A>", {{"Duration", "better", "A 3 s, B 2 s"}}, {"One pair is left out."}}}, {});
        for (const char* const words : {"B is better than <A>.", "✓ better", "A 3 s, B 2 s", "One pair is left out."})
            QVERIFY2(view.text().contains(QString::fromUtf8(words)), qPrintable(view.text()));
    }

private:
    std::unique_ptr<CampaignPanel> panel_;
};

USAR_TEST(tst_CampaignPanel)

} // namespace tst_campaign_panel

#include "tst_campaign_panel.moc"
