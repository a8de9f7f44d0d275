# What the modules call of the C interface, whose header says all about it. The C compiler compares types.
from libc.stdint cimport int32_t, int64_t, uint64_t

cdef extern from "qtraj.h" nogil:
    enum:
        QTRAJ_OK
        QTRAJ_E_COUNT
        QTRAJ_E_TIME_RANGE
        QTRAJ_E_AMBIGUOUS
        QTRAJ_E_NO_CONVERGENCE
        QTRAJ_CLASS_DATA
        QTRAJ_CLASS_ONE_OF_SEVERAL
    ctypedef struct qtraj_options:
        pass
    ctypedef struct qtraj_trajectory:
        pass
    ctypedef struct qtraj_vector_curve:
        pass
    ctypedef struct qtraj_key_report:
        uint64_t faults
        uint64_t sign_changes
        uint64_t first_sign_change
        double worst_norm_error
        uint64_t worst_norm_index
        double largest_angle
        uint64_t largest_angle_index
        double longest_interval
        uint64_t longest_interval_index
        double shortest_interval
        uint64_t shortest_interval_index

    const char* qtraj_version()
    const char* qtraj_status_text(int32_t status)
    int32_t qtraj_status_class(int32_t status)
    const char* qtraj_target()
    int qtraj_options_init(void* memory, size_t bytes, int32_t method, qtraj_options** out)
    int qtraj_options_set_ends(qtraj_options* options, int32_t start, int32_t end)
    int qtraj_options_set_end_rates(qtraj_options* options, int32_t frame, const double* omega_start,
        const double* omega_end)
    int qtraj_options_set_tangents(qtraj_options* options, int32_t rule)
    int qtraj_options_set_reference(qtraj_options* options, int32_t rule, const double* q_wb)
    int qtraj_options_set_extrapolation(qtraj_options* options, int32_t before, int32_t after)
    int qtraj_options_set_turns(qtraj_options* options, int32_t rule)
    int qtraj_options_set_period(qtraj_options* options, double period)
    int qtraj_options_set_closure(qtraj_options* options, double angle)
    int qtraj_options_set_longest_gap(qtraj_options* options, double seconds)
    int qtraj_create_with_options(const qtraj_options* options, const double* times, const double* q_wb,
        size_t count, qtraj_trajectory** out, size_t* bad_index)
    int qtraj_create_with_options_f32(const qtraj_options* options, const double* times, const float* q_wb,
        size_t count, qtraj_trajectory** out, size_t* bad_index)
    int qtraj_create_with_rates(const qtraj_options* options, int32_t frame, const double* times,
        const double* q_wb, const double* omega, const double* alpha, size_t count, qtraj_trajectory** out,
        size_t* bad_index)
    int qtraj_create_with_rates_f32(const qtraj_options* options, int32_t frame, const double* times,
        const float* q_wb, const float* omega, const float* alpha, size_t count, qtraj_trajectory** out,
        size_t* bad_index)
    int qtraj_create_with_turns(const qtraj_options* options, int32_t frame, const double* times,
        const double* q_wb, const double* omega, const double* alpha, const int32_t* turns, size_t count,
        qtraj_trajectory** out, size_t* bad_index)
    int qtraj_create_with_turns_f32(const qtraj_options* options, int32_t frame, const double* times,
        const float* q_wb, const float* omega, const float* alpha, const int32_t* turns, size_t count,
        qtraj_trajectory** out, size_t* bad_index)
    int qtraj_create_with_tangents(const qtraj_options* options, const double* times, const double* q_wb,
        const double* in_tangents, const double* out_tangents, size_t count, qtraj_trajectory** out,
        size_t* bad_index)
    int qtraj_create_with_tangents_f32(const qtraj_options* options, const double* times, const float* q_wb,
        const float* in_tangents, const float* out_tangents, size_t count, qtraj_trajectory** out,
        size_t* bad_index)
    void qtraj_destroy(qtraj_trajectory* trajectory)
    int qtraj_sample(const qtraj_trajectory* trajectory, const double* times, size_t count, double* q_out,
        size_t* bad_index)
    int qtraj_sample_f32(const qtraj_trajectory* trajectory, const double* times, size_t count, float* q_out,
        size_t* bad_index)
    int qtraj_sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const double* times, size_t count,
        double* q_out, double* omega_out, double* alpha_out, size_t* bad_index)
    int qtraj_sample_rates_f32(const qtraj_trajectory* trajectory, int32_t frame, const double* times,
        size_t count, float* q_out, float* omega_out, float* alpha_out, size_t* bad_index)
    int qtraj_sample_many(const qtraj_trajectory* const* trajectories, size_t series, int32_t frame,
        const double* times, size_t count, int32_t layout, double* q_out, double* omega_out, double* alpha_out,
        size_t* bad_index)
    int qtraj_sample_many_f32(const qtraj_trajectory* const* trajectories, size_t series, int32_t frame,
        const double* times, size_t count, int32_t layout, float* q_out, float* omega_out, float* alpha_out,
        size_t* bad_index)
    int qtraj_sample_unnormalized(const qtraj_trajectory* trajectory, const double* times, size_t count,
        double* p_out, double* dp_out, double* ddp_out, size_t* bad_index)
    int qtraj_sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
        double* q_out, size_t* bad_index)
    int qtraj_sample_uniform_f32(const qtraj_trajectory* trajectory, double start, double step, size_t count,
        float* q_out, size_t* bad_index)
    int qtraj_uniform_count(const qtraj_trajectory* trajectory, double start, double step, size_t* count)
    int qtraj_even_times(double first, double last, size_t count, double* times_out)
    int qtraj_segment_times(const qtraj_trajectory* trajectory, size_t per_segment, double* times_out)
    int qtraj_sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, double* q_out)
    int qtraj_sample_at_f32(const qtraj_trajectory* trajectory, double time, size_t* cursor, float* q_out)
    size_t qtraj_key_count(const qtraj_trajectory* trajectory)
    double qtraj_start_time(const qtraj_trajectory* trajectory)
    double qtraj_end_time(const qtraj_trajectory* trajectory)
    size_t qtraj_sign_flips(const qtraj_trajectory* trajectory)
    double qtraj_worst_norm_error(const qtraj_trajectory* trajectory)
    double qtraj_least_dot(const qtraj_trajectory* trajectory)
    int32_t qtraj_iterations(const qtraj_trajectory* trajectory)
    double qtraj_residual(const qtraj_trajectory* trajectory)
    int qtraj_keys(const qtraj_trajectory* trajectory, double* times_out, double* q_out)
    int qtraj_curve_least_norm(const qtraj_trajectory* trajectory, double* norm, double* time)
    int qtraj_curve_jumps(const qtraj_trajectory* trajectory, int32_t frame, double* omega_jump, double* alpha_jump)
    int qtraj_curve_peak_rates(const qtraj_trajectory* trajectory, double* omega_peak, double* omega_time,
        double* alpha_peak, double* alpha_time)
    int qtraj_rate_bounds(const qtraj_trajectory* trajectory, double* omega, double* alpha)
    int qtraj_rate_mismatch(const qtraj_trajectory* trajectory, double* angle, size_t* index)
    int qtraj_curve_energy(const qtraj_trajectory* trajectory, double* energy)
    int qtraj_curve_total_angle(const qtraj_trajectory* trajectory, double* angle)
    int qtraj_vector_create(const qtraj_options* options, const double* times, const double* values,
        const double* first, const double* second, size_t count, size_t dim, qtraj_vector_curve** out,
        size_t* bad_index)
    int qtraj_vector_create_f32(const qtraj_options* options, const double* times, const float* values,
        const float* first, const float* second, size_t count, size_t dim, qtraj_vector_curve** out,
        size_t* bad_index)
    void qtraj_vector_destroy(qtraj_vector_curve* curve)
    int qtraj_vector_sample(const qtraj_vector_curve* curve, const double* times, size_t count, double* value_out,
        double* first_out, double* second_out, size_t* bad_index)
    int qtraj_vector_sample_f32(const qtraj_vector_curve* curve, const double* times, size_t count,
        float* value_out, float* first_out, float* second_out, size_t* bad_index)
    int qtraj_vector_sample_uniform(const qtraj_vector_curve* curve, double start, double step, size_t count,
        double* value_out, double* first_out, double* second_out, size_t* bad_index)
    int qtraj_vector_sample_uniform_f32(const qtraj_vector_curve* curve, double start, double step, size_t count,
        float* value_out, float* first_out, float* second_out, size_t* bad_index)
    int qtraj_vector_uniform_count(const qtraj_vector_curve* curve, double start, double step, size_t* count)
    size_t qtraj_vector_key_count(const qtraj_vector_curve* curve)
    size_t qtraj_vector_dim(const qtraj_vector_curve* curve)
    double qtraj_vector_start_time(const qtraj_vector_curve* curve)
    double qtraj_vector_end_time(const qtraj_vector_curve* curve)
    int qtraj_vector_keys(const qtraj_vector_curve* curve, double* times_out, double* values_out)
    int qtraj_sample_poses(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions, int32_t frame,
        const double* times, size_t count, double* q_out, double* omega_out, double* alpha_out, double* p_out,
        double* v_out, double* a_out, size_t* bad_index)
    int qtraj_sample_poses_f32(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
        int32_t frame, const double* times, size_t count, float* q_out, float* omega_out, float* alpha_out,
        float* p_out, float* v_out, float* a_out, size_t* bad_index)
    int qtraj_batch_sample(const qtraj_options* options, size_t count, const int64_t* key_offsets,
        const double* key_times, const double* key_q_wb, const int64_t* sample_offsets, const double* sample_times,
        void* memory, size_t bytes, double* q_out, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_sample_f32(const qtraj_options* options, size_t count, const int64_t* key_offsets,
        const double* key_times, const float* key_q_wb, const int64_t* sample_offsets, const double* sample_times,
        void* memory, size_t bytes, float* q_out, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_sample_rates(const qtraj_options* options, int32_t frame, size_t count,
        const int64_t* key_offsets, const double* key_times, const double* key_q_wb, const double* key_omega,
        const double* key_alpha, const int64_t* sample_offsets, const double* sample_times, void* memory,
        size_t bytes, double* q_out, double* omega_out, double* alpha_out, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_sample_rates_f32(const qtraj_options* options, int32_t frame, size_t count,
        const int64_t* key_offsets, const double* key_times, const float* key_q_wb, const float* key_omega,
        const float* key_alpha, const int64_t* sample_offsets, const double* sample_times, void* memory,
        size_t bytes, float* q_out, float* omega_out, float* alpha_out, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_step_offsets(size_t count, const int64_t* key_offsets, const double* key_times,
        const double* step, size_t step_count, int64_t* sample_offsets_out, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_times(size_t count, const int64_t* key_offsets, const double* key_times, const double* step,
        size_t step_count, const int64_t* sample_offsets, double* times_out, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_mean_eigen(size_t count, const int64_t* offsets, const double* q, const double* weights,
        double* mean_out, double* eigengap, int32_t* status_out, size_t* bad_index)
    int qtraj_batch_mean_eigen_f32(size_t count, const int64_t* offsets, const float* q, const float* weights,
        float* mean_out, double* eigengap, int32_t* status_out, size_t* bad_index)
    int qtraj_squad_controls(const double* times, const double* q_wb, size_t count, double* a_out, double* b_out,
        size_t* bad_index)
    int qtraj_check_keys(const double* times, const double* q_wb, size_t count, int32_t* status_out,
        qtraj_key_report* report, size_t* bad_index)
    int qtraj_check_keys_f32(const double* times, const float* q_wb, size_t count, int32_t* status_out,
        qtraj_key_report* report, size_t* bad_index)
    int qtraj_seconds_from_ns(const int64_t* ns, size_t count, int64_t origin, double* seconds_out)
    int qtraj_rows_from_columns(const double* const* columns, size_t width, size_t count, double* rows_out)
    int qtraj_rows_from_columns_f32(const float* const* columns, size_t width, size_t count, float* rows_out)
    int qtraj_columns_from_rows(const double* rows, size_t width, size_t count, double* const* columns_out)
    int qtraj_columns_from_rows_f32(const float* rows, size_t width, size_t count, float* const* columns_out)
    int qtraj_estimate_omega(int32_t frame, const double* times, const double* q_wb, size_t count,
        double* t_mid_out, double* omega_out, size_t* bad_index)
    int qtraj_estimate_energy(int32_t frame, const double* times, const double* q_wb, size_t count, double* energy,
        size_t* bad_index)
    int qtraj_estimate_jumps(int32_t frame, const double* times, const double* q_wb, size_t count,
        const double* knots, size_t knot_count, double* jump_out, size_t* bad_index)
    int qtraj_keyframe_errors(const double* key_times, const double* key_q, size_t key_count, const double* times,
        const double* q_wb, size_t count, double* error_out, size_t* index_out, size_t* bad_index)
    int qtraj_cubic_spline(const double* x, const double* y, size_t count, size_t dim, int32_t start, int32_t end,
        const double* queries, size_t query_count, double* y_out, size_t* bad_index)
    int qtraj_make_continuous_strided(const double* q, size_t series, size_t series_stride, size_t length,
        size_t key_stride, double* q_out, size_t* flips, size_t* bad_index)
    int qtraj_make_continuous_strided_f32(const float* q, size_t series, size_t series_stride, size_t length,
        size_t key_stride, float* q_out, size_t* flips, size_t* bad_index)
    int qtraj_mean_eigen(const double* q, const double* weights, size_t count, double* mean_out, double* eigengap,
        size_t* bad_index)
    int qtraj_mean_eigen_f32(const float* q, const float* weights, size_t count, float* mean_out, double* eigengap,
        size_t* bad_index)
    int qtraj_mean_karcher(const double* q, const double* weights, size_t count, double tolerance,
        int32_t max_iterations, double* mean_out, int32_t* iterations, double* residual, size_t* bad_index)
    int qtraj_mean_karcher_f32(const float* q, const float* weights, size_t count, double tolerance,
        int32_t max_iterations, float* mean_out, int32_t* iterations, double* residual, size_t* bad_index)
    int qtraj_moments_add(const double* q, const double* weights, size_t count, double* moments, size_t* bad_index)
    int qtraj_moments_add_f32(const float* q, const float* weights, size_t count, double* moments,
        size_t* bad_index)
