// The dock Campaign, driven as a person does it.
#pragma once

#include <QListWidget>
#include <QSpinBox>
#include <QTabBar>

#include "tests/e2e/window_page.h"
#include "widgets/campaign/campaign_panel.h"

/// The page must outlive it.
class CampaignDock {
public:
    explicit CampaignDock(WindowPage& page) : page_(page), panel_(*page.window().views().campaign) {}

    usar::widgets::CampaignPanel& panel() { return panel_; }
    usar::widgets::RunTable& table() { return panel_.table(); }

    void open() {
        page_.window().commands().action("view.dock.campaign")->trigger();
        QVERIFY(QTest::qWaitFor([&] { return panel_.isVisible(); }));
    }
    /// Until the form has the mission that is set up.
    bool hasMission() {
        return QTest::qWaitFor([&] { return behaviors().count() > 0; }, soon_ms);
    }
    void typeSeeds(int first, int count) {
        typeNumber("First seed", first);
        typeNumber("Number of seeds", count);
    }
    void typeJobs(int jobs) { typeNumber("Missions at a time", jobs); }
    /// Changes the check mark of the behavior whose name has these words.
    void toggleBehavior(const QString& words) {
        for (int row = 0; row < behaviors().count(); ++row)
            if (behaviors().item(row)->text().contains(words)) {
                behaviors().setCurrentRow(row);
                return QTest::keyClick(&behaviors(), Qt::Key_Space);
            }
        QTest::qFail(qPrintable("no behavior " + words), __FILE__, __LINE__);
    }
    void showPage(usar::widgets::CampaignPanel::Page page) {
        auto* const bar = panel_.findChild<QTabBar*>();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(page).center());
    }
    /// In the row of the run with this number, as it is shown now.
    void doubleClickRun(int number) {
        const QPoint at = placeOf(number);
        QTest::mouseClick(runs().viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(runs().viewport(), Qt::LeftButton, {}, at);
    }
    void clickRun(int number) { QTest::mouseClick(runs().viewport(), Qt::LeftButton, {}, placeOf(number)); }
    bool ends(int runs) {
        return QTest::qWaitFor([&] { return table().rowCount() == runs; }, flight_ms) &&
               QTest::qWaitFor([&] { return !panel_.verdict()->text().trimmed().isEmpty(); }, soon_ms);
    }
    QTableView& runs() { return *panel_.runs()->view(); }

private:
    QListWidget& behaviors() { return *panel_.form()->findChild<QListWidget*>(); }
    void typeNumber(const QString& name, int number) {
        for (QSpinBox* const box : panel_.form()->findChildren<QSpinBox*>())
            if (box->accessibleName() == name) {
                box->selectAll();
                QTest::keyClicks(box, QString::number(number));
                return QTest::keyClick(box, Qt::Key_Return);
            }
        QTest::qFail(qPrintable("no field " + name), __FILE__, __LINE__);
    }
    QPoint placeOf(int number) {
        const QAbstractItemModel& shown = *runs().model();
        for (int row = 0; row < shown.rowCount(); ++row)
            if (shown.index(row, 0).data().toInt() == number) {
                runs().scrollTo(shown.index(row, 0));
                return runs().visualRect(shown.index(row, 1)).center();
            }
        QTest::qFail("the run is not in the table", __FILE__, __LINE__);
        return {};
    }

    WindowPage& page_;
    usar::widgets::CampaignPanel& panel_;
};
