#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "src/exchange/project_io/plan_calendar.hpp"
#include "src/exchange/project_io/project.hpp"

/// How values of a schedule are said in a plan: the same on the way there, and on the way back to
/// see whether somebody has changed them in the plan.
namespace rubicon::project_io {

/// The moment at which the plan starts: of the project, else the first start of a task; empty if
/// none has one. Whole minutes.
Moment plan_start(const Project& project);

/// Seconds of a task in the plan.
std::int64_t plan_seconds(const Task& task);

/// Whether a task has an elapsed duration: it goes on in nights and on days off too, whatever the
/// calendars of those who are assigned to it, as in Microsoft Project.
bool runs_day_and_night(const Task& task);

/// Whether its own calendar alone says when it goes on, whatever the shifts of those on it.
bool goes_by_itself(const Task& task);

/// Whether a calendar of the project works day and night, every day.
bool works_always(const Project& project, std::int64_t calendar);

/// How many people or machines a crew has: whole ones, at least one. A schedule may give a resource
/// of 150 %, of which half a one can do nothing in a plan.
double crew_size(const Resource& resource);

/// How many people of a crew of that size a task has in the plan, where a schedule has so many
/// units of the resource on it: whole ones, at least one, at most all.
double crew_people(double units, double size);

/// Cost per hour of so many of a resource; nothing if there is none, or it is not by time. A rate
/// is by the hour whatever unit of time it is shown in: rate_format is how Project shows it.
std::optional<double> cost_per_hour(const Resource& resource, double size);

/// The calendar of a crew: the resource's own, else the project's.
std::int64_t crew_calendar(const Project& project, const Resource& resource);

/// A calendar with a week and days off each for itself: what a plan says without help.
Calendar calendar_of(const PlanCalendar& plan, std::int64_t uid, const std::string& name);

}  // namespace rubicon::project_io
