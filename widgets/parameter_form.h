// A form for the parameters of a behavior, made from their specs: grouped, searchable, fine at 280 px.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>

#include "core/agent/parameters.h"

namespace usar::widgets {

class EmptyState;
class ParameterRow;

/// Values in by setters, edits out by `changed`. Values are SI and radians; angles are shown and edited in degrees.
/// What was set for one list of specs is kept while another is shown and comes back with it.
/// A modified row has a bar at its left, a bold label and a button back to the default. Search and "modified only"
/// hide rows and never change values. GUI thread; rows belong to the form.
class ParameterForm : public QWidget {
    Q_OBJECT
public:
    explicit ParameterForm(QWidget* parent = nullptr);

    /// Groups in the order in which they first appear. The same specs again change nothing; others are built with the
    /// values that they had when they were last shown, else at their defaults.
    void setSpecs(const std::vector<agent::ParameterSpec>& specs);
    /// Ids without a row are ignored; values that do not fit their spec show its default. Does not emit `changed`.
    void setValues(const std::map<std::string, agent::ParameterValue>& values);
    std::map<std::string, agent::ParameterValue> values() const;
    /// Those that differ from their defaults: what a mission file needs to keep.
    std::map<std::string, agent::ParameterValue> modified() const;

    /// Shows rows with `words` in label, id, group or help.
    void setFilter(const QString& words);
    void setModifiedOnly(bool on);
    /// Shown while there are no specs.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {320, 400}; }

public slots:
    /// Tells once, and not at all where nothing was modified.
    void resetAll();

signals:
    /// After every edit by the person, with all values.
    void changed(const std::map<std::string, usar::agent::ParameterValue>& values);

private:
    struct Group {
        QLabel* header = nullptr;
        std::vector<ParameterRow*> rows;
    };

    /// Search, "modified only", reset all.
    QWidget* makeTools();
    Group& groupOf(const std::string& name);
    void buildRows();
    void keepModified();
    void applyFilter();
    void rowEdited();

    QLineEdit* search_;
    QToolButton* modified_only_;
    QToolButton* reset_all_; ///< seen only while something is modified
    QScrollArea* scroll_;
    QLabel* nothing_; ///< says why the filter leaves no row
    EmptyState* empty_state_;
    std::vector<agent::ParameterSpec> specs_;
    std::vector<std::pair<std::string, Group>> groups_; ///< in the order of the specs
    /// What differed from its default when specs were last shown; few behaviors, so a list will do.
    std::vector<std::pair<std::vector<agent::ParameterSpec>, std::map<std::string, agent::ParameterValue>>> kept_;
};

} // namespace usar::widgets
