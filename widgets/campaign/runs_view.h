// The table of a campaign's runs with its filter.
#pragma once

#include <optional>

#include <QCheckBox>
#include <QLineEdit>
#include <QMenu>
#include <QSet>
#include <QTableView>

#include "widgets/models/campaign/run_table.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// A run of the same seed with another variant.
struct RunPartner {
    int number = 0;
    QString variant;
};

/// Double-click and Return fly the run of the row again. Rows that come keep the sorting and the selection. GUI thread.
class RunsView : public QWidget {
    Q_OBJECT
public:
    /// The table must outlive the view.
    explicit RunsView(RunTable& table, QWidget* parent = nullptr);

    /// Number of the run in the current row; nullopt if there is none.
    std::optional<int> currentRun() const;
    /// Numbers of the runs in the selected rows, from above.
    std::vector<int> selectedRuns() const;
    QTableView* view() const { return view_; }
    EmptyState* emptyState() const { return nothing_; } ///< It is shown while there is no run.
    /// The menu of a row offers these; the actions must outlive the view.
    void setActions(QAction* fly, QAction* fly_pair, QAction* copy);
    /// The menu of the current row offers to compare it with each of these, if there are several.
    void setPartners(const std::vector<RunPartner>& partners) { partners_ = partners; }
    /// The menu of the current row; it belongs to the caller.
    QMenu* makeRowMenu();

signals:
    /// A row was double-clicked, or Return was pressed in it.
    void runChosen(int number);
    /// The current row or the selection is another one.
    void currentChanged();
    /// The current run is to be compared with the run of this number.
    void partnerChosen(int number);

private:
    void setUpTable();
    void wire();
    void showCount();
    /// Makes the column of variants wide enough for the names in these rows of the table that are new.
    void widenFor(int first_row, int last_row);

    RunTable& table_;
    RunFilter* filter_;
    std::vector<RunPartner> partners_;
    QLineEdit* words_;
    QCheckBox* only_failures_ = new QCheckBox(tr("Not done only"), this);
    QLabel* count_ = mutedLabel({}, this);
    QTableView* view_ = new QTableView(this);
    EmptyState* nothing_;
    bool sized_ = false;     ///< The columns have the widths that the first rows need.
    QSet<QString> variants_; ///< The column is wide enough for them.
};

} // namespace usar::widgets
