// Why runs of a campaign were not done: the runs grouped by what ended them.
#pragma once

#include <vector>

#include <QTreeWidget>

namespace usar::widgets {

class EmptyState;

/// A run of a cause, with what its own reason says of time and place.
struct CausedRun {
    int number = 0;
    QString name;   ///< "Run 4, POSH, seed 3"
    QString reason; ///< The run told it so, with its numbers.
    bool operator==(const CausedRun&) const = default;
};

struct CauseRow {
    QString reason;
    QString variants; ///< How often each variant met it: "C++ 3, POSH 1".
    std::vector<CausedRun> runs;
    bool operator==(const CauseRow&) const = default;
};

/// The causes are rows that can be opened; their runs are below them, and a double-click or Return flies one again. GUI
/// thread.
class CauseList : public QWidget {
    Q_OBJECT
public:
    explicit CauseList(QWidget* parent = nullptr);

    /// Shows these causes; those that were opened stay open. `any_runs`: the campaign has results.
    void setCauses(const std::vector<CauseRow>& causes, bool any_runs);
    QTreeWidget* tree() const { return tree_; }

signals:
    void runChosen(int number);

private:
    void choose(const QTreeWidgetItem* item);

    std::vector<CauseRow> causes_;
    QTreeWidget* tree_ = new QTreeWidget(this);
    EmptyState* nothing_;
};

} // namespace usar::widgets
