// The list of what was edited: a click goes back or forward to that moment.
#pragma once

#include <functional>

#include <QUndoView>
#include <QWidget>

class QUndoStack;

namespace usar::widgets {

class EmptyState;

/// Rows that cannot be undone are gray and say why; what was undone stays below the chosen row until the next edit. GUI
/// thread.
class HistoryPanel : public QWidget {
    Q_OBJECT
public:
    /// Why the command in a row of the stack cannot be undone; empty if it can.
    using ReasonOf = std::function<QString(int row)>;

    explicit HistoryPanel(QWidget* parent = nullptr);

    /// The stack must outlive the panel. To be called once.
    void setHistory(QUndoStack* stack, ReasonOf reason_of);
    /// Shows reasons that have changed.
    void refresh();
    QSize sizeHint() const override { return {280, 240}; }

private:
    QUndoView* list_;
    EmptyState* nothing_;
};

} // namespace usar::widgets
