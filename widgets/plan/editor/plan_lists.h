// The lists below a plan that is edited: findings, differences from another version, and usages or losses of an export.
#pragma once

#include <vector>

#include <QListWidget>
#include <QTabWidget>

#include "core/posh/edit/plan_difference.h"
#include "core/posh/language/plan_export.h"
#include "core/posh/model/finding.h"
#include "widgets/models/plan/plan_places.h"

namespace usar::widgets {

/// GUI thread.
class PlanLists : public QTabWidget {
    Q_OBJECT
public:
    explicit PlanLists(QWidget* parent = nullptr);

    /// Lists findings, then notes; the current row stays.
    void showFindings(const posh::Findings& findings, const std::vector<PlanNote>& notes);
    /// Lists differences and shows that tab. `is_partial`: one of the plans could not be read completely.
    void showDifferences(const std::vector<posh::PlanChange>& changes, bool is_partial);
    /// Lists all places that use the part, and shows that tab.
    void showUsages(const posh::Plan& plan, const posh::PlanPart& part);
    void clearUsages() { usages_->clear(); }
    /// Lists what an export could not express in place of usages; shows that tab if there is anything.
    void showLosses(const std::vector<posh::Loss>& losses);

signals:
    /// The user chose a row that has a place in the text.
    void placeChosen(const usar::posh::Spot& at);

private:
    /// Adds a tab with a list, which shows `title` and `hint` while it is empty.
    QListWidget* addList(const QString& name, const QString& help, const QString& title, const QString& hint);

    QListWidget* findings_;
    QListWidget* differences_;
    QListWidget* usages_;
};

} // namespace usar::widgets
