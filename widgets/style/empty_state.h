// Sheet that a view shows while it is empty: what will appear here, and a button that makes it appear.
#pragma once

#include <QPushButton>

#include "widgets/style/form_parts.h"

namespace usar::widgets {

/// Shows a title, one sentence (which becomes the tooltip where there is no room for it) and, with an action, a button.
/// Covers its parent and follows its size; the mouse reaches the parent except on the button.
class EmptyState : public QWidget {
    Q_OBJECT
public:
    /// `covered` becomes the parent; the texts are those of setText().
    explicit EmptyState(QWidget* covered, const QString& title = {}, const QString& hint = {});

    /// Says what is missing and how to make it appear; both also become the accessible name and description.
    void setText(const QString& title, const QString& hint);
    /// Shows a button that triggers `action` and has its text; nullptr hides it. The action must outlive this sheet.
    /// An action that is not what the view is for gets a plain button: `role` is empty.
    void setAction(QAction* action, const char* role = "primary");
    /// Whether the action, if there is one, would make something appear as things are now; true at first.
    void offerAction(bool helps);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Leaves the sentence out if it would be cut.
    void fit();

    QLabel* title_ = new QLabel(this);
    QLabel* hint_ = mutedLabel({}, this);
    QPushButton* button_ = new QPushButton(this);
    bool has_action_ = false;
    bool action_helps_ = true;
    QMetaObject::Connection clicked_;
};

} // namespace usar::widgets
