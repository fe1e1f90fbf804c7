// Why runs of a campaign were not done: the runs grouped by what ended them.
#pragma once

#include <vector>

#include <QTreeWidget>

namespace usar::widgets {

class EmptyState;

/// A run of a cause, with what its own reason says of time and place.
struct CausedRun {
    int number = 0;
    QString name;    ///< "Run 4, POSH, seed 3"
    QString reason;  ///< The run told it so, with its numbers.
    QString place{}; ///< It ended there: "around x 15 m, y -5 m"; empty if it is not known.
    bool operator==(const CausedRun&) const = default;
};

struct CauseRow {
    QString reason;
    QString variants;            ///< How often each variant met it: "3 × C++, 1 × POSH".
    std::vector<CausedRun> runs; ///< Those of one place follow each other.
    bool operator==(const CauseRow&) const = default;
};

/// The causes are rows that can be opened; their places and runs are below them, and a double-click or Return flies one
/// again. GUI thread.
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
