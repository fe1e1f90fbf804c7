#include "widgets/panels/history_panel.h"

#include <utility>

#include <QStyledItemDelegate>
#include <QUndoStack>

#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// Paints rows that cannot be undone in gray, with the reason. The first row of the list is the beginning.
class HistoryDelegate : public QStyledItemDelegate {
public:
    HistoryDelegate(HistoryPanel::ReasonOf reason_of, QObject* parent)
        : QStyledItemDelegate(parent)
        , reason_of_(std::move(reason_of)) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, minimum_target});
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->icon = {};
        const QString reason = reason_of_(index.row() - 1);
        if (reason.isEmpty())
            return;
        option->text += QStringLiteral(" – ") + reason;
        option->font.setItalic(true);
        option->palette.setColor(QPalette::Text, tokens().text_muted); // on the selection's fill it could not be read
    }

private:
    HistoryPanel::ReasonOf reason_of_;
};

} // namespace

HistoryPanel::HistoryPanel(QWidget* parent) : QWidget(parent), list_(new QUndoView(this)) {
    named(list_, tr("History"), tr("What was edited, the oldest first; a click goes back or forward to that moment"));
    list_->setEmptyLabel(tr("Beginning"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setMinimumHeight(3 * minimum_target);
    laidOut(new QVBoxLayout(this), {gap::small, 0, gap::small, gap::small}, 0, {list_});
    nothing_ = new EmptyState(list_, tr("Nothing was edited yet"),
                              tr("Areas, parameters, objects and layers that you change appear here."));
}

void HistoryPanel::setHistory(QUndoStack* stack, ReasonOf reason_of) {
    list_->setStack(stack);
    list_->setItemDelegate(new HistoryDelegate(std::move(reason_of), list_));
    refresh();
}

void HistoryPanel::refresh() {
    nothing_->setVisible(!list_->stack() || list_->stack()->count() == 0);
    list_->viewport()->update();
}

} // namespace usar::widgets
