// The table of a campaign's runs with its filter.
#pragma once

#include <optional>

#include <QCheckBox>
#include <QLineEdit>
#include <QTableView>

#include "widgets/models/campaign/run_table.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// Double-click and Return fly the run of the row again. Rows that come keep the sorting and the selection. GUI thread.
class RunsView : public QWidget {
    Q_OBJECT
public:
    /// The table must outlive the view.
    explicit RunsView(RunTable& table, QWidget* parent = nullptr);

    /// Number of the run in the current row; nullopt if there is none.
    std::optional<int> currentRun() const;
    QTableView* view() const { return view_; }
    EmptyState* emptyState() const { return nothing_; } ///< It is shown while there is no run.
    /// The menu of a row offers these; the actions must outlive the view.
    void setActions(QAction* fly, QAction* fly_pair, QAction* copy);

signals:
    /// A row was double-clicked, or Return was pressed in it.
    void runChosen(int number);
    void currentChanged();

private:
    void showCount();

    RunTable& table_;
    RunFilter* filter_;
    QLineEdit* words_;
    QCheckBox* only_failures_ = new QCheckBox(tr("Not done only"), this);
    QLabel* count_ = mutedLabel({}, this);
    QTableView* view_ = new QTableView(this);
    EmptyState* nothing_;
};

} // namespace usar::widgets
