#include "core/mission/edits/edit_history.h"

#include <utility>

#include <QScopedValueRollback>

namespace usar::mission {

namespace {
constexpr int most_rows = 200;
}

/// One row of the history.
class EditHistory::Step : public QUndoCommand {
public:
    Step(EditHistory& history, Edit edit, const QString& reason)
        : QUndoCommand(edit.text)
        , history_(history)
        , edit_(std::move(edit))
        , reason_(reason) {}

    const QString& subject() const { return edit_.subject; }
    const QString& reason() const { return reason_; }
    void lock(const QString& reason) const { reason_ = reason; }

    int id() const override { return edit_.merges ? 1 : -1; }
    void redo() override {
        if (!std::exchange(fresh_, false)) // The stack calls this for a new step, too.
            run(edit_.redo);
    }
    void undo() override { run(edit_.undo); }
    bool mergeWith(const QUndoCommand* other) override {
        const auto* const later = static_cast<const Step*>(other); // The stack has no others.
        if (!history_.open_ || !reason_.isEmpty() || later->edit_.subject != edit_.subject || !later->edit_.same)
            return false;
        edit_.redo = later->edit_.redo;
        edit_.after = later->edit_.after;
        setObsolete(edit_.same(edit_.before, edit_.after));
        return true;
    }

private:
    void run(const std::function<void()>& change) {
        if (!reason_.isEmpty())
            return;
        const QScopedValueRollback applying(history_.applying_, true);
        change();
    }

    EditHistory& history_;
    Edit edit_;
    mutable QString reason_; ///< QUndoStack gives its commands as constant ones only
    bool fresh_ = true;
};

EditHistory::EditHistory(QObject* parent) : QObject(parent) {
    stack_.setUndoLimit(most_rows);
    connect(&stack_, &QUndoStack::indexChanged, this, &EditHistory::changed);
}

void EditHistory::add(Edit edit) {
    if (applying_ || (edit.same && edit.same(edit.before, edit.after)))
        return;
    const bool merges = edit.merges;
    stack_.push(new Step(*this, std::move(edit), {})); // The stack owns it.
    open_ = merges;
}

void EditHistory::addStep(Edit edit) {
    endStep();
    add(std::move(edit));
    endStep();
}

void EditHistory::note(const QString& text) {
    if (applying_ || stack_.index() < stack_.count())
        return;
    open_ = false;
    stack_.push(new Step(*this, Edit{{}, text, {}, {}}, tr("was sent and cannot be undone")));
}

void EditHistory::lock(const std::function<bool(const QString& subject)>& concerned, const QString& reason) {
    for (int row = 0; row < stack_.count(); ++row)
        if (step(row)->reason().isEmpty() && concerned(step(row)->subject()))
            step(row)->lock(reason);
    emit changed();
}

const EditHistory::Step* EditHistory::step(int row) const {
    return static_cast<const Step*>(stack_.command(row));
}

int EditHistory::undoable() const {
    int row = stack_.index() - 1;
    while (row >= 0 && !step(row)->reason().isEmpty())
        --row;
    return row;
}

int EditHistory::redoable() const {
    for (int row = stack_.index(); row < stack_.count(); ++row)
        if (step(row)->reason().isEmpty())
            return row;
    return -1;
}

QString EditHistory::undoText() const {
    return canUndo() ? step(undoable())->text() : QString();
}

QString EditHistory::redoText() const {
    return canRedo() ? step(redoable())->text() : QString();
}

void EditHistory::undo() {
    if (canUndo())
        goTo(undoable());
}

void EditHistory::redo() {
    if (canRedo())
        goTo(redoable() + 1);
}

void EditHistory::goTo(int index) {
    open_ = false;
    stack_.setIndex(index);
}

QString EditHistory::reasonOf(int row) const {
    return row >= 0 && row < stack_.count() ? step(row)->reason() : QString();
}

} // namespace usar::mission
