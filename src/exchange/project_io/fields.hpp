#pragma once

#include "src/exchange/project_io/project.hpp"

/// The plain fields of the model: once for all that read and write them. `visit(word, element,
/// member)` is called for each, in the order of the MSPDI schema
/// (http://schemas.microsoft.com/project): `word` is the field's name in a plan, `element` in the
/// XML. Calendars and links have no such table: they have a form of their own in each file.
namespace rubicon::project_io {

template <typename ProjectType, typename Visit>
void visit_project(ProjectType& project, Visit& visit) {
  visit("name", "Name", project.name);
  visit("title", "Title", project.title);
  visit("subject", "Subject", project.subject);
  visit("company", "Company", project.company);
  visit("manager", "Manager", project.manager);
  visit("author", "Author", project.author);
  visit("from_start", "ScheduleFromStart", project.schedule_from_start);
  visit("start", "StartDate", project.start);
  visit("finish", "FinishDate", project.finish);
  visit("currency", "CurrencySymbol", project.currency_symbol);
  visit("currency_code", "CurrencyCode", project.currency_code);
  visit("calendar", "CalendarUID", project.calendar);
  visit("minutes_per_day", "MinutesPerDay", project.minutes_per_day);
  visit("minutes_per_week", "MinutesPerWeek", project.minutes_per_week);
  visit("days_per_month", "DaysPerMonth", project.days_per_month);
}

template <typename TaskType, typename Visit>
void visit_task(TaskType& task, Visit& visit) {
  visit("uid", "UID", task.uid);
  visit("id", "ID", task.id);
  visit("name", "Name", task.name);
  visit("active", "Active", task.active);
  visit("manual", "Manual", task.manual);
  visit("type", "Type", task.type);
  visit("code", "WBS", task.code);
  visit("level", "OutlineLevel", task.level);
  visit("priority", "Priority", task.priority);
  visit("start", "Start", task.start);
  visit("finish", "Finish", task.finish);
  visit("duration", "Duration", task.duration);
  visit("format", "DurationFormat", task.format);
  visit("work", "Work", task.work);
  visit("effort_driven", "EffortDriven", task.effort_driven);
  visit("milestone", "Milestone", task.milestone);
  visit("summary", "Summary", task.summary);
  visit("fixed_cost", "FixedCost", task.fixed_cost);
  visit("fixed_cost_accrual", "FixedCostAccrual", task.fixed_cost_accrual);
  visit("percent_complete", "PercentComplete", task.percent_complete);
  visit("actual_start", "ActualStart", task.actual_start);
  visit("actual_finish", "ActualFinish", task.actual_finish);
  visit("constraint", "ConstraintType", task.constraint);
  visit("calendar", "CalendarUID", task.calendar);
  visit("constraint_date", "ConstraintDate", task.constraint_date);
  visit("deadline", "Deadline", task.deadline);
  visit("ignores_resource_calendars", "IgnoreResourceCalendar", task.ignores_resource_calendars);
  visit("notes", "Notes", task.notes);
  visit("hide_bar", "HideBar", task.hide_bar);
}

template <typename ResourceRecord, typename Visit>
void visit_resource(ResourceRecord& resource, Visit& visit) {
  visit("uid", "UID", resource.uid);
  visit("id", "ID", resource.id);
  visit("name", "Name", resource.name);
  visit("type", "Type", resource.type);
  visit("initials", "Initials", resource.initials);
  visit("material_label", "MaterialLabel", resource.material_label);
  visit("code", "Code", resource.code);
  visit("group", "Group", resource.group);
  visit("email", "EmailAddress", resource.email);
  visit("max_units", "MaxUnits", resource.max_units);
  visit("rate", "StandardRate", resource.standard_rate);
  visit("rate_format", "StandardRateFormat", resource.rate_format);
  visit("overtime_rate", "OvertimeRate", resource.overtime_rate);
  visit("overtime_rate_format", "OvertimeRateFormat", resource.overtime_rate_format);
  visit("cost_per_use", "CostPerUse", resource.cost_per_use);
  visit("calendar", "CalendarUID", resource.calendar);
  visit("notes", "Notes", resource.notes);
}

template <typename AssignmentType, typename Visit>
void visit_assignment(AssignmentType& assignment, Visit& visit) {
  visit("uid", "UID", assignment.uid);
  visit("task", "TaskUID", assignment.task);
  visit("resource", "ResourceUID", assignment.resource);
  visit("percent_complete", "PercentWorkComplete", assignment.percent_complete);
  visit("finish", "Finish", assignment.finish);
  visit("start", "Start", assignment.start);
  visit("units", "Units", assignment.units);
  visit("work", "Work", assignment.work);
}

}  // namespace rubicon::project_io
