// Everything that the user has edited in the window, in one order, so that it can be undone and redone.
#pragma once

#include <any>
#include <functional>

#include <QObject>
#include <QUndoStack>

namespace usar::mission {

/// An edit that has been done.
struct Edit {
    QString subject;            ///< what was edited, from the large to the small: "robot 1/area"
    QString text;               ///< what was done, to stand after "Undo": "move area of R1"
    std::function<void()> undo; ///< may not throw; edits that it makes itself are not recorded
    std::function<void()> redo;
    /// Consecutive edits of one subject become one step, until `EditHistory::endStep`.
    bool merges = false;
    std::any before{}; ///< the value of an edit by `valueEdit`, or empty
    std::any after{};
    /// Compares two such values. An edit that ends where it began leaves no step.
    bool (*same)(const std::any&, const std::any&) = nullptr;
};

/// An edit that replaces one value by another; `apply` is called with the value that should be there. T has ==.
template <class T>
Edit valueEdit(const QString& subject, const QString& text, T before, T after, std::function<void(const T&)> apply) {
    Edit edit{subject, text, [apply, before] { apply(before); }, [apply, after] { apply(after); }, true, {}, {}, {}};
    edit.before = std::move(before);
    edit.after = std::move(after);
    edit.same = [](const std::any& one, const std::any& other) {
        return std::any_cast<const T&>(one) == std::any_cast<const T&>(other);
    };
    return edit;
}

/// The history of the window; the plan editor has another one for its text. Besides edits it has rows that cannot be
/// undone, with the reason: commands that were sent, and edits of what is gone. Undo and redo pass over them. Keeps the
/// newest 200 rows. Belongs to one thread.
class EditHistory : public QObject {
    Q_OBJECT
public:
    explicit EditHistory(QObject* parent = nullptr);

    /// Adds an edit that has been done; what was undone before cannot be redone any more. While an edit is being undone
    /// or redone this does nothing, because the views report that change like any other.
    void add(Edit edit);
    /// Adds an edit that never becomes one step with those before and after it.
    void addStep(Edit edit);
    /// Adds a row that cannot be undone: `text` was sent. It stays out while something can be redone, because a command
    /// to a robot must not take that away.
    void note(const QString& text);
    /// The next edit begins a step of its own: a drag has ended.
    void endStep() { open_ = false; }
    /// Edits of these subjects cannot be undone any more.
    void lock(const std::function<bool(const QString& subject)>& concerned, const QString& reason);

    bool canUndo() const { return undoable() >= 0; }
    bool canRedo() const { return redoable() >= 0; }
    /// What the next undo or redo is about: "move area of R1"; empty if there is none.
    QString undoText() const;
    QString redoText() const;
    void undo();
    void redo();

    /// For views. Rows count from 0, the oldest.
    QUndoStack* stack() { return &stack_; }
    /// Why a row cannot be undone; empty if it can.
    QString reasonOf(int row) const;

signals:
    /// Texts, reasons, or what can be undone or redone may be different now.
    void changed();

private:
    class Step;
    const Step* step(int row) const;
    /// The row that the next undo or redo is about; -1: none.
    int undoable() const;
    int redoable() const;
    void goTo(int index);

    QUndoStack stack_;
    bool open_ = false;     ///< the newest step may grow
    bool applying_ = false; ///< an edit is being undone or redone
};

} // namespace usar::mission
